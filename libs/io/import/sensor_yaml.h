#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>

#include "flownav/config/config.h"

namespace flownav::io {

/// What EuRoC's sensor.yaml of a camera tells.
struct SensorYaml {
    std::optional<Eigen::Isometry3d> T_body_camera;
    int width_px = 0;  ///< 0: not told
    int height_px = 0;
    std::optional<std::array<double, 4>> intrinsics;  ///< fx, fy, cx, cy
    std::optional<std::array<double, 4>> distortion;  ///< k1, k2, p1, p2; empty for another lens model
};

/// Reads the file; parts that it lacks stay empty. Throws InputError when it is no YAML.
SensorYaml read_sensor_yaml(const std::filesystem::path& file);

/// Fills the intrinsics and the distortion that `camera` leaves open; returns true when some were.
bool fill_open_keys(const SensorYaml& sensor, config::CameraConfig& camera);

}  // namespace flownav::io
