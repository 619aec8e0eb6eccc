#pragma once
#include <filesystem>

#include "flownav/config/config.h"
#include "flownav/evaluation/pose_fit.h"

namespace flownav::calibration {

/// Start of a calibration.
struct CalibrationStart {
    config::Config config;  ///< with angles that fit the beginning of the drive
    CameraMount given;      ///< the given mount, or the first guess
};

/// Fits the given pose to the first stretch of the drive. When it agrees with few vectors, or there is none,
/// tries pitches from 5 to 65 degrees. With odometry the height may be unknown. Throws InputError, and
/// ConfigError when the camera cannot be used.
CalibrationStart find_start(const std::filesystem::path& input, config::Config config, bool odometry);

/// True when the configuration allows the angles of the mount.
bool within_ranges(const CameraMount& mount);

void set_angles(config::Config& config, const CameraMount& mount);

}  // namespace flownav::calibration
