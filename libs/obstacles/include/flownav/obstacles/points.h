#pragma once
#include <Eigen/Core>
#include <optional>

#include "flownav/core/obstacle_point.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/core/pose2.h"
#include "flownav/obstacles/classify.h"

namespace flownav::obstacles {

/// Point at `at` on the level camera's normalised plane and depth Z along the optical axis, in the robot
/// frame (x forward, y left, z up), in metres.
Eigen::Vector3d point_in_robot(const Eigen::Vector2d& at, double depth_m, const CameraMount& mount);

/// 3D point of an obstacle vector, in the robot frame at the end of the cycle. The point is measured from the
/// robot's pose in the MIDDLE of the vector's interval and moved by T_end_mid. Empty outside the limits of
/// `params`, or when the standard deviation of the depth exceeds 12 %.
std::optional<ObstaclePoint> obstacle_point(const Classification& classification,
                                            const Eigen::Vector2d& last_at_px, const Pose2& T_end_mid,
                                            const CameraMount& mount, double sigma_travel_relative,
                                            const ObstacleParams& params);

/// Floor covered by a ground vector's 16x16 block in the reference field, moved to the end of the cycle by
/// T_end_reference. Empty when the block reaches near or above the horizon or farther than `range_max_m`.
std::optional<GroundPatch> ground_patch(const Eigen::Vector2d& centre_px, const RayMapper& reference,
                                        const Pose2& T_end_reference, double range_max_m);

}  // namespace flownav::obstacles
