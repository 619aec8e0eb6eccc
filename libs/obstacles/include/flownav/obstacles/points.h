#pragma once
#include <Eigen/Core>
#include <optional>

#include "flownav/core/obstacle_point.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/core/pose2.h"
#include "flownav/obstacles/classify.h"

namespace flownav::obstacles {

/// A point of the level camera's view at depth Z (along its axis), in the robot frame: x forward, y left, z
/// up.
Eigen::Vector3d point_in_robot(const Eigen::Vector2d& at, double depth_m, const CameraMount& mount);

/// The 3D point of an obstacle vector. It is seen from where the robot was in the MIDDLE of the vector's
/// interval and moved to the end of the cycle by T_end_mid. Nothing when it lies out of the limits of
/// `params` or its depth is worthless (deviation above a tenth of the range).
std::optional<ObstaclePoint> obstacle_point(const Classification& classification,
                                            const Eigen::Vector2d& last_at_px, const Pose2& T_end_mid,
                                            const CameraMount& mount, double sigma_travel_relative,
                                            const ObstacleParams& params);

/// The floor that a ground vector's 16x16 block covered in the reference field, as a segment along the line
/// of sight; moved to the end of the cycle by T_end_reference. Nothing when the block reaches over the
/// horizon or farther than `range_max_m`.
std::optional<GroundPatch> ground_patch(const Eigen::Vector2d& centre_px, const RayMapper& reference,
                                        const Pose2& T_end_reference, double range_max_m);

}  // namespace flownav::obstacles
