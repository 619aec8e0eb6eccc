#include "local/rollout.h"

#include <gtest/gtest.h>

#include <vector>

namespace flownav::nav {
namespace {

constexpr double step_s = 0.05;

/// Steps of a robot that follows `command` for `hold_s` and is then told to stop.
std::vector<RolloutStep> steps_of(const MotionCommand& motion, const MotionCommand& command, double hold_s) {
    std::vector<RolloutStep> steps;
    rollout(
        RobotModel(), motion, step_s,
        [&](double t) { return t < hold_s ? std::optional(command) : std::nullopt; },
        [&](const RolloutStep& step) {
            steps.push_back(step);
            return true;
        });
    return steps;
}

TEST(Rollout, TheWayIsThatOfSpeedingUpOfDrivingAndOfBraking) {
    // 0.8 s at 0.5 m/s2, 0.2 s at 0.4 m/s, 0.4 s at -1 m/s2.
    const std::vector<RolloutStep> steps = steps_of({}, {0.4, 0.0}, 1.0);
    EXPECT_EQ(steps.size(), 28U);
    EXPECT_NEAR(steps.back().T_start_robot.x_m, 0.16 + 0.08 + 0.08, 1e-12);
    EXPECT_NEAR(steps.front().mean.v_mps, 0.0125, 1e-12);
    EXPECT_TRUE(steps.back().stands);
    EXPECT_FALSE(steps[steps.size() - 2].stands);
}

TEST(Rollout, LeftTurnsLeft) {
    for (const double side : {1.0, -1.0}) {
        const Pose2 end = steps_of({0.4, 0.0}, {0.4, 0.8 * side}, 1.0).back().T_start_robot;
        EXPECT_NEAR(end.yaw_rad, side * 0.8, 1e-9);  // slowing down takes as long as speeding up
        EXPECT_GT(end.y_m * side, 0.05);
    }
}

TEST(Rollout, ARobotThatStandsForAMomentWithoutBeingToldToStopGoesOn) {
    const std::vector<RolloutStep> steps = steps_of({}, {}, 0.5);
    EXPECT_EQ(steps.size(), 11U);
    EXPECT_TRUE(steps.back().stands);
}

TEST(Rollout, EndsWhenTheVisitorReturnsFalse) {
    int visited = 0;
    rollout(
        RobotModel(), {0.4, 0.0}, step_s,
        [](double) {
            return std::optional(MotionCommand{0.4, 0.0});
        },
        [&](const RolloutStep&) { return ++visited < 3; });
    EXPECT_EQ(visited, 3);
}

TEST(Rollout, OfARobotThatIsNeverToldToStopEnds) {
    int visited = 0;
    rollout(
        RobotModel(), {0.4, 0.0}, step_s,
        [](double) {
            return std::optional(MotionCommand{0.4, 0.0});
        },
        [&](const RolloutStep&) { return ++visited < 100000; });
    EXPECT_NEAR(visited * step_s, rollout_max_s, step_s);
}

}  // namespace
}  // namespace flownav::nav
