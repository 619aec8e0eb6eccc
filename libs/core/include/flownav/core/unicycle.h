#pragma once
#include <algorithm>
#include <cmath>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"

namespace flownav {

/// Pose after moving steadily for `time_s`, from the identity.
inline Pose2 pose_after(const MotionCommand& motion, double time_s) {
    const double turn_rad = motion.omega_radps * time_s;
    const double way_m = motion.v_mps * time_s;
    const double half_rad = turn_rad / 2;
    const double chord_m = std::abs(half_rad) < 1e-9 ? way_m : way_m * std::sin(half_rad) / half_rad;
    return along_arc(turn_rad, chord_m);
}

/// Value moved toward a target by at most `change`; equals the target when it is within reach.
inline double moved_toward(double value, double target, double change) {
    return std::clamp(target, value - change, value + change);
}

/// Motion after following `command` for `time_s` at the limits of the model: brake_mps2 toward standstill,
/// also when the direction reverses, accel_mps2 away from it, alpha_radps2 for turns.
inline MotionCommand motion_after(const RobotModel& robot, const MotionCommand& motion,
                                  const MotionCommand& command, double time_s) {
    const bool brakes =
        std::abs(command.v_mps) < std::abs(motion.v_mps) || command.v_mps * motion.v_mps < 0.0;
    const double change_mps = (brakes ? robot.brake_mps2 : robot.accel_mps2) * time_s;
    return {moved_toward(motion.v_mps, command.v_mps, change_mps),
            moved_toward(motion.omega_radps, command.omega_radps, robot.alpha_radps2 * time_s)};
}

}  // namespace flownav
