#pragma once

#include <cmath>
#include <optional>

#include "flownav/core/unicycle.h"

namespace flownav::nav {

/// One step of a rollout.
struct RolloutStep {
    Pose2 T_start_robot;  ///< at the end of the step
    MotionCommand mean;   ///< motion during the step
    bool stands = false;  ///< the robot was told to stop and stands at the end of the step
};

/// Longest rollout; every robot stands by then.
constexpr double rollout_max_s = 20.0;

/// Plays commands in steps of `step_s` until the robot stands, from the identity and moving with `motion`.
/// `command_at(time_s)` returns the command that the motors follow in the step that begins at `time_s`,
/// empty once they are told to stop. Calls visit(step) after each step and ends early when it returns false.
template <class CommandAt, class Visit>
void rollout(const RobotModel& robot, MotionCommand motion, double step_s, const CommandAt& command_at,
             const Visit& visit) {
    constexpr double standing = 1e-6;  // sum of m/s and rad/s
    RolloutStep step;
    for (int i = 0; i * step_s < rollout_max_s && !step.stands; ++i) {
        const std::optional<MotionCommand> command = command_at(i * step_s);
        const MotionCommand next = motion_after(robot, motion, command.value_or(MotionCommand{}), step_s);
        step.mean = {(motion.v_mps + next.v_mps) / 2, (motion.omega_radps + next.omega_radps) / 2};
        step.T_start_robot = compose(step.T_start_robot, pose_after(step.mean, step_s));
        step.stands = !command && std::abs(next.v_mps) + std::abs(next.omega_radps) < standing;
        motion = next;
        if (!visit(step)) return;
    }
}

}  // namespace flownav::nav
