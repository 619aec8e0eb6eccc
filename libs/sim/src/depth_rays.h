#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>

#include "flownav/core/camera_model.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

/// Pose of a camera on a robot that rides on its ground, see ride_on_ground(): axes x right, y down, z along
/// the optical axis.
Eigen::Isometry3d camera_pose(const CameraMount& mount, const Pose2& T_world_robot,
                              const Eigen::Isometry3d& T_flat_robot);

/// Depth along the optical axis of every pixel (CV_32F, metres, 0 where a ray meets no surface), from the
/// exact shapes.
cv::Mat1f exact_depth(const World& world, const CameraModel& camera, const Eigen::Isometry3d& T_world_camera,
                      double time_s);

}  // namespace flownav::sim
