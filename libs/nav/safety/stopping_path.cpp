#include "flownav/nav/stopping_path.h"

#include <cmath>

#include "flownav/math/footprint.h"
#include "local/rollout.h"

namespace flownav::nav {
namespace {

constexpr double tick_s = 0.01;

/// Newest command issued up to `time_s`; `before` when there is none.
MotionCommand command_before(const std::deque<TimedCommand>& sent, const MotionCommand& before,
                             double time_s) {
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
    const auto command_at = [&](double rollout_s) -> std::optional<MotionCommand> {
        const double issued_s = time_s + (rollout_s + tick_s / 2) - robot.delay_s;
        if (issued_s >= stop_s) return {};
        return issued_s >= candidate.time_s ? candidate.command : command_before(sent, motion, issued_s);
    };
    std::vector<Pose2> path = {Pose2{}};
    double moved_m = 0.0;
    rollout(robot, motion, tick_s, command_at, [&](const RolloutStep& step) {
        moved_m += (std::abs(step.mean.v_mps) + std::abs(step.mean.omega_radps) * radius_m) * tick_s;
        if (moved_m >= step_m || (step.stands && moved_m > 0.0)) {
            path.push_back(step.T_start_robot);
            moved_m = 0.0;
        }
        return true;
    });
    return path;
}

}  // namespace flownav::nav
