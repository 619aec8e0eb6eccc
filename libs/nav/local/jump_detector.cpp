#include "flownav/nav/jump_detector.h"

#include <algorithm>
#include <cmath>

namespace flownav::nav {

MotionCommand plausible_motion(const RobotModel& robot, const MotionCommand& motion) {
    const double omega_max_radps = overspeed_factor * robot.omega_max_radps;
    return {
        std::clamp(motion.v_mps, -overspeed_factor * robot.v_back_mps, overspeed_factor * robot.v_max_mps),
        std::clamp(motion.omega_radps, -omega_max_radps, omega_max_radps)};
}

JumpDetector::JumpDetector(const RobotModel& robot, double slack_m, double slack_rad)
    : v_max_mps_(overspeed_factor * std::max(robot.v_max_mps, robot.v_back_mps)),
      omega_max_radps_(overspeed_factor * robot.omega_max_radps),
      slack_m_(slack_m),
      slack_rad_(slack_rad) {}

bool JumpDetector::is_jump(const Pose2& T_frame_from, const Pose2& T_frame_to, double time_s) const {
    const Pose2 T_from_to = compose(inverse(T_frame_from), T_frame_to);
    const bool possible = std::hypot(T_from_to.x_m, T_from_to.y_m) <= v_max_mps_ * time_s + slack_m_ &&
                          std::abs(T_from_to.yaw_rad) <= omega_max_radps_ * time_s + slack_rad_;
    return !possible;  // also when a comparison with NaN failed
}

}  // namespace flownav::nav
