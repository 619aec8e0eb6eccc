#pragma once

#include <Eigen/Core>
#include <vector>

#include "flownav/nav/lanes.h"

namespace flownav::nav {

/// Middles of the occupied cells that a robot can meet before it stands again.
std::vector<Eigen::Vector2d> obstacles_near(const LaneTables& tables, const std::vector<CellKind>& kinds,
                                            double within_m);

/// Whether the robot, moving now, told `command` until the next decision and then to stop, touches nothing.
bool can_still_stop(const LaneTables& tables, const std::vector<Eigen::Vector2d>& obstacles_m,
                    const MotionCommand& motion, const MotionCommand& command, const LaneParams& params);

}  // namespace flownav::nav
