#include "flownav/nav/stopping_path.h"

#include <algorithm>
#include <cmath>

#include "flownav/math/footprint.h"
#include "flownav/nav/motion_model.h"

namespace flownav::nav {
namespace {

constexpr double tick_s = 0.01;
constexpr double longest_s = 20.0;  // no robot brakes longer
constexpr double slowest = 1e-6;

double approach(double value, double target, double change) {
    return std::clamp(target, value - change, value + change);
}

MotionCommand step(const RobotModel& robot, const MotionCommand& motion, const MotionCommand& command) {
    const bool brakes = motion.v_mps * (command.v_mps - motion.v_mps) < 0.0;
    const double change = (brakes ? robot.brake_mps2 : robot.accel_mps2) * tick_s;
    return {approach(motion.v_mps, command.v_mps, change),
            approach(motion.omega_radps, command.omega_radps, robot.alpha_radps2 * tick_s)};
}

/// The command that reaches the motors at `time_s`, without its delay.
MotionCommand command_at(const std::deque<TimedCommand>& sent, const MotionCommand& before, double time_s) {
    MotionCommand command = before;
    for (const TimedCommand& timed : sent)
        if (timed.time_s <= time_s) command = timed.command;
    return command;
}

}  // namespace

std::vector<Pose2> stopping_path(const RobotModel& robot, const MotionCommand& motion,
                                 const std::deque<TimedCommand>& sent, double time_s,
                                 const TimedCommand& candidate, double hold_s, double step_m) {
    const double radius_m = circumscribed_radius_m(robot.footprint_m);
    const double stop_s = candidate.time_s + hold_s;
    std::vector<Pose2> path = {Pose2{}};
    Pose2 pose;
    MotionCommand now = motion;
    double moved_m = 0.0;
    for (int tick = 0; tick * tick_s < longest_s; ++tick) {
        const double issued_s = time_s + (tick + 0.5) * tick_s - robot.delay_s;
        MotionCommand command = command_at(sent, motion, issued_s);
        if (issued_s >= candidate.time_s) command = candidate.command;
        if (issued_s >= stop_s) command = {};
        const MotionCommand next = step(robot, now, command);
        const MotionCommand mean{(now.v_mps + next.v_mps) / 2, (now.omega_radps + next.omega_radps) / 2};
        pose = compose(pose, pose_after(mean, tick_s));
        moved_m += (std::abs(mean.v_mps) + std::abs(mean.omega_radps) * radius_m) * tick_s;
        now = next;
        const bool stands = std::abs(now.v_mps) + std::abs(now.omega_radps) < slowest;
        const bool over = issued_s >= stop_s && stands;
        if (moved_m >= step_m || (over && moved_m > 0.0)) {
            path.push_back(pose);
            moved_m = 0.0;
        }
        if (over) break;
    }
    return path;
}

}  // namespace flownav::nav
