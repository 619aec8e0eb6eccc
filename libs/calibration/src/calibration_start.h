#pragma once
#include <filesystem>

#include "flownav/config/config.h"
#include "flownav/evaluation/pose_fit.h"

namespace flownav::calibration {

/// Where a calibration starts.
struct CalibrationStart {
    config::Config config;  ///< with angles that explain the beginning of the drive
    CameraMount given;      ///< what was known before, or the first guess
};

/// Tries the given pose on the first stretch of the drive, and where that explains little, or there is none,
/// pitches from 5 to 65 degrees. With odometry the height need not be known either.
/// Throws InputError, and ConfigError when the camera cannot be used.
CalibrationStart find_start(const std::filesystem::path& input, config::Config config, bool odometry);

/// Whether the configuration allows these angles.
bool within_ranges(const CameraMount& mount);

void set_angles(config::Config& config, const CameraMount& mount);

}  // namespace flownav::calibration
