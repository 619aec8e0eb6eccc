#pragma once

#include <Eigen/Core>
#include <vector>

#include "flownav/core/obstacle_point.h"

namespace flownav::obstacles {

/// Removes floor behind obstacle points of the same cycle, because obstacles occlude it and their lowest
/// parts are easily taken for the floor behind them. Cuts a patch at the nearest point within 1.5 degrees of
/// its bearing from the camera, or drops it. Points, patches and `camera_m` are in one frame.
void remove_occluded_floor(const std::vector<ObstaclePoint>& points, const Eigen::Vector2d& camera_m,
                           std::vector<GroundPatch>& ground);

}  // namespace flownav::obstacles
