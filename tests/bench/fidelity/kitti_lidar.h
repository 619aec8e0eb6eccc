#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <vector>

#include "flownav/core/camera_model.h"

namespace flownav::fidelity {

/// The laser scans of a raw KITTI drive, one per image.
class KittiLidar {
  public:
    /// `mount` is that of the camera 02. Throws std::runtime_error when the calibration cannot be read.
    KittiLidar(const std::filesystem::path& date_folder, const std::filesystem::path& drive_folder,
               const CameraMount& mount);

    /// Returns of scan `number`, in the ROBOT frame of its time; empty when the scan is missing.
    std::vector<Eigen::Vector3d> scan(int number) const;

  private:
    std::filesystem::path folder_;
    Eigen::Isometry3d T_robot_lidar_;
};

/// Transform from the level camera (x right, y down, z forward) to the robot frame.
Eigen::Isometry3d robot_from_level(const CameraMount& mount);

/// Pixel of a point of the robot frame, which must lie ahead of the camera.
Eigen::Vector2d project(const RayMapper& mapper, const Eigen::Vector3d& point_m);

}  // namespace flownav::fidelity
