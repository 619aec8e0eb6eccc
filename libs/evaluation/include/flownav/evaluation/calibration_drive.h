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

/// Vectors between a reference and a newer field, in pixels, so that they can be evaluated with any camera
/// pose.
struct CalibrationPair {
    double begin_s = 0.0;
    double end_s = 0.0;
    CameraModel reference;  ///< camera as used by the sensor
    CameraModel newer;
    EgoMotion motion;
    std::vector<FlowVector> vectors;  ///< unambiguous vectors only
};

/// Data of a drive for a calibration.
struct CalibrationDrive {
    std::vector<CalibrationPair> pairs;  ///< at most 1200, an even selection of a long drive
    std::uint64_t cycles = 0;
    std::uint64_t fields = 0;
    double duration_s = 0.0;
    double path_m = 0.0;  ///< path length by flow odometry
    Field first_field;
    PoseTrack odometry;
    io::ReadEnd end;
    std::string stop_reason;  ///< reason why reading stopped before the end; empty when it did not
};

/// Runs the sensor over the rawlog until `cycles_max` cycles are finished (0: to the end). Throws InputError,
/// and ConfigError when the first image cannot be used.
CalibrationDrive collect_pairs(const std::filesystem::path& input, const config::Config& config,
                               std::uint64_t cycles_max, cli::Progress& progress);

}  // namespace flownav::evaluation
