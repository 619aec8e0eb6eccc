#pragma once

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"

namespace flownav::nav {

/// A robot that is pushed or rolls downhill moves at most this many times as fast as its model.
constexpr double overspeed_factor = 1.5;

/// Limits a measured motion to overspeed_factor times the speeds of the model.
MotionCommand plausible_motion(const RobotModel& robot, const MotionCommand& motion);

/// Detects pose steps that are farther than a robot can move.
class JumpDetector {
  public:
    /// A step may exceed the way or the turn of the fastest motion by `slack_m` and `slack_rad`.
    JumpDetector(const RobotModel& robot, double slack_m, double slack_rad);

    /// True when the robot cannot have moved from one pose to the other in `time_s`, and for poses that are
    /// not finite. Both poses are in the same frame.
    bool is_jump(const Pose2& T_frame_from, const Pose2& T_frame_to, double time_s) const;

  private:
    double v_max_mps_;
    double omega_max_radps_;
    double slack_m_;
    double slack_rad_;
};

}  // namespace flownav::nav
