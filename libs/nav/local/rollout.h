#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <vector>

#include "flownav/nav/lanes.h"

namespace flownav::nav {

/// Middles of the occupied cells that a robot can meet before it stands again.
std::vector<Eigen::Vector2d> obstacles_near(const mrpt::maps::COccupancyGridMap2D& map,
                                            const std::vector<CellKind>& kinds, double within_m);

/// How far obstacles can matter to can_still_stop().
double reach_m(const RobotModel& robot, const FootprintField& field, const LaneParams& params);

/// Whether the robot, moving now, told `command` until the next decision and then to stop, touches nothing.
bool can_still_stop(const RobotModel& robot, const FootprintField& field,
                    const std::vector<Eigen::Vector2d>& obstacles_m, const MotionCommand& motion,
                    const MotionCommand& command, const LaneParams& params);

}  // namespace flownav::nav
