#pragma once

#include "flownav/nav/lanes.h"
#include "flownav/nav/navigator.h"

namespace flownav::nav {

/// What CReactiveNavigationSystem lacks: braking distances, unseen ground, and turning on the spot toward a
/// way point behind the robot.
class SpeedLimiter {
  public:
    SpeedLimiter(const RobotModel& robot, const LaneParams& params, double period_s);

    bool wants_to_turn(const Eigen::Vector2d& waypoint_robot_m, const MotionCommand& motion) const;
    /// Turns on the spot, the short way round if that is free; stuck when neither is.
    Decision turn_to(const Situation& situation, const Eigen::Vector2d& waypoint_robot_m) const;
    /// The command, slow enough for what lies on its way; stuck when it leads nowhere.
    Decision limit(const Situation& situation, const MotionCommand& command) const;

  private:
    RobotModel robot_;
    LaneParams params_;
    CollisionFreeParams free_way_;
    FootprintField field_;
};

}  // namespace flownav::nav
