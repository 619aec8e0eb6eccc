#pragma once

#include <Eigen/Core>
#include <vector>

#include "flownav/core/contact_scan.h"
#include "flownav/core/obstacle_point.h"

namespace flownav::obstacles {

/// Removes floor behind obstacle points of the same cycle, because obstacles occlude it and their lowest
/// parts are easily taken for the floor behind them. Cuts a patch at the nearest point within 1.5 degrees of
/// its bearing from the camera, or drops it. Points, patches and `camera_m` are in one frame.
void remove_occluded_floor(const std::vector<ObstaclePoint>& points, const Eigen::Vector2d& camera_m,
                           std::vector<GroundPatch>& ground);

/// Removes floor behind the contacts of the newest scan in the same way: behind the near end of the interval
/// of each obstacle, over the width of its strip and 1.5 degrees to either side. Patches and `camera_m` are
/// in the robot frame of the RECORD, which the robot may have reached after the scan; contacts that the
/// camera has passed hide nothing.
void remove_floor_behind_contacts(const ContactScan& contacts, const Eigen::Vector2d& camera_m,
                                  std::vector<GroundPatch>& ground);

}  // namespace flownav::obstacles
