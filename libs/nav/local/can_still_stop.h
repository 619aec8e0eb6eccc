#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <vector>

#include "flownav/nav/lanes.h"

namespace flownav::nav {

/// Middles of the occupied cells nearer than `within_m` to the origin, in the frame of the map (m).
std::vector<Eigen::Vector2d> obstacles_near(const mrpt::maps::COccupancyGridMap2D& map,
                                            const std::vector<CellKind>& kinds, double within_m);

/// Distance from the robot beyond which obstacles do not change can_still_stop() (m).
double reach_m(const RobotModel& robot, const FootprintField& field, const LaneParams& params);

/// True when the robot touches no obstacle while it moves with `motion`, follows `command` for
/// params.period_s and stops. Obstacles are in the robot frame.
bool can_still_stop(const RobotModel& robot, const FootprintField& field,
                    const std::vector<Eigen::Vector2d>& obstacles_m, const MotionCommand& motion,
                    const MotionCommand& command, const LaneParams& params);

}  // namespace flownav::nav
