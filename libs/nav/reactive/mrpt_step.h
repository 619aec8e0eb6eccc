#pragma once

#include <mrpt/nav/reactive/CWaypointsNavigator.h>

#include "flownav/nav/grid_robot.h"

namespace flownav::nav {

/// One step of a navigator of MRPT's toward a way point; `robot` holds the command afterwards. False when the
/// way point is reached, to 5 cm: then nothing was decided.
bool step(mrpt::nav::CWaypointsNavigator& system, GridRobot& robot, const Situation& situation,
          const Eigen::Vector2d& waypoint_m);

Decision at_way_point();

/// Nothing goes to the console unless `verbose`.
void set_verbosity(mrpt::nav::CWaypointsNavigator& system, bool verbose);

}  // namespace flownav::nav
