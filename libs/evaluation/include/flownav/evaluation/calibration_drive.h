#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "flownav/cli/progress.h"
#include "flownav/config/config.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/field.h"
#include "flownav/core/flow_vector.h"
#include "flownav/evaluation/pose_track.h"
#include "flownav/io/field_source.h"

namespace flownav::evaluation {

/// The vectors of one finished cycle, in pixels, so that they can be seen with any camera pose.
struct CalibrationPair {
    double begin_s = 0.0;
    double end_s = 0.0;
    CameraModel reference;  ///< as the sensor used it
    CameraModel newer;
    EgoMotion motion;
    std::vector<FlowVector> vectors;  ///< the unambiguous ones
};

/// What a drive gives for a calibration.
struct CalibrationDrive {
    std::vector<CalibrationPair> pairs;  ///< of a long drive a selection, spread evenly
    std::uint64_t cycles = 0;
    std::uint64_t fields = 0;
    double duration_s = 0.0;
    double path_m = 0.0;  ///< flow odometry
    Field first_field;
    PoseTrack odometry;
    io::ReadEnd end;
    std::string stop_reason;  ///< why reading stopped before the end; empty when it did not
};

/// Runs the sensor over the rawlog, until `cycles_max` cycles are finished (0: to the end).
/// Throws InputError and, when not even the first image can be used, ConfigError.
CalibrationDrive collect_pairs(const std::filesystem::path& input, const config::Config& config,
                               std::uint64_t cycles_max, cli::Progress& progress);

}  // namespace flownav::evaluation
