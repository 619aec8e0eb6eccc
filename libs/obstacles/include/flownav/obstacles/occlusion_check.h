#pragma once

#include <Eigen/Core>
#include <vector>

#include "flownav/core/obstacle_point.h"

namespace flownav::obstacles {

/// Takes back the floor behind obstacle points of the same cycle: what stands there hides it, and the lowest
/// part of something looks as far away as the floor behind its foot. Patches are cut at the nearest point
/// within 1.5 degrees of their bearing from the camera, or dropped. Points, patches and `camera_m` are in one
/// frame.
void remove_occluded_floor(const std::vector<ObstaclePoint>& points, const Eigen::Vector2d& camera_m,
                           std::vector<GroundPatch>& ground);

}  // namespace flownav::obstacles
