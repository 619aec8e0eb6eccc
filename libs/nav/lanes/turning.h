#pragma once

#include <Eigen/Core>
#include <cmath>

#include "flownav/nav/lanes.h"

namespace flownav::nav {

inline double bearing_rad(const Eigen::Vector2d& p) {
    return std::atan2(p.y(), p.x());
}

/// True for a way point behind the robot, and for a robot that is turning on the spot until the way point is
/// ahead.
bool wants_to_turn(const Eigen::Vector2d& waypoint_robot_m, const MotionCommand& motion,
                   const LaneParams& params);

/// Command to turn on the spot by an angle (> 0 to the left), slower toward its end.
MotionCommand turn_by(const RobotModel& robot, double angle_rad);

}  // namespace flownav::nav
