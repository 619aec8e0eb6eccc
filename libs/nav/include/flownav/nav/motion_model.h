#pragma once

#include "flownav/core/unicycle.h"

namespace flownav::nav {

/// Way a robot that moves with `v_mps` needs until it stands: the delay of the command, and braking.
double stopping_distance_m(const RobotModel& robot, double v_mps);

/// Fastest speed, >= 0, from which the robot stands within `free_m`; inverse of stopping_distance_m().
double stoppable_speed_mps(const RobotModel& robot, double free_m);

}  // namespace flownav::nav
