#include "flownav/nav/stopping_path.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double exact_m = 1e-6;

/// Path of a robot that gets a command at time 0, without pending commands.
std::vector<Pose2> path_of(const RobotModel& robot, const MotionCommand& motion,
                           const MotionCommand& candidate, double hold_s, double step_m = 0.02) {
    return stopping_path(robot, motion, {}, 0.0, {0.0, candidate}, hold_s, step_m);
}

Pose2 end_of(const MotionCommand& motion, const MotionCommand& candidate, double hold_s) {
    return path_of(RobotModel(), motion, candidate, hold_s).back();
}

TEST(StoppingPath, StraightItIsTheWayOfTheDelayAndOfBraking) {
    for (const double v_mps : {0.05, 0.4, 1.0, -0.15}) {
        RobotModel robot;
        robot.brake_mps2 = 0.8;
        const Pose2 end = path_of(robot, {v_mps, 0.0}, {}, 0.0).back();
        const double way_m = std::abs(v_mps) * robot.delay_s + v_mps * v_mps / (2 * robot.brake_mps2);
        // The path has ticks of 10 ms; braking ends within the last one.
        EXPECT_NEAR(end.x_m, std::copysign(way_m, v_mps), 0.01 * 0.01 * robot.brake_mps2);
        EXPECT_EQ(end.y_m, 0.0);
        EXPECT_EQ(end.yaw_rad, 0.0);
    }
}

TEST(StoppingPath, AHeldCommandLengthensItByItsSpeedTimesItsTime) {
    const double at_once_m = end_of({0.4, 0.0}, {0.4, 0.0}, 0.0).x_m;
    for (const double hold_s : {0.1, 0.3, 1.0})
        EXPECT_NEAR(end_of({0.4, 0.0}, {0.4, 0.0}, hold_s).x_m - at_once_m, 0.4 * hold_s, exact_m);
}

TEST(StoppingPath, FromStandstillItSpeedsUpAndBrakes) {
    // 0.8 s at 0.5 m/s2, 0.2 s at 0.4 m/s, 0.4 s at -1 m/s2.
    EXPECT_NEAR(end_of({}, {0.4, 0.0}, 1.0).x_m, 0.16 + 0.08 + 0.08, exact_m);
    // Backward: 0.2 s at -0.5 m/s2, 0.8 s at -0.1 m/s, 0.1 s at 1 m/s2.
    EXPECT_NEAR(end_of({}, {-0.1, 0.0}, 1.0).x_m, -(0.01 + 0.08 + 0.005), exact_m);
}

TEST(StoppingPath, ReversingBrakesBeforeItSpeedsUpTheOtherWay) {
    // 0.1 s at 0.4 m/s, 0.4 s of braking; 0.2 s to -0.1 m/s, 0.4 s of it, 0.1 s of braking.
    EXPECT_NEAR(end_of({0.4, 0.0}, {-0.1, 0.0}, 1.0).x_m, 0.04 + 0.08 - (0.01 + 0.04 + 0.005), exact_m);
}

TEST(StoppingPath, LeftEndsLeftAndRightIsItsMirrorImage) {
    const Pose2 left = end_of({0.3, 0.0}, {0.3, 0.6}, 0.5);
    const Pose2 right = end_of({0.3, 0.0}, {0.3, -0.6}, 0.5);
    EXPECT_GT(left.y_m, 0.01);
    EXPECT_GT(left.yaw_rad, 0.1);
    EXPECT_NEAR(right.x_m, left.x_m, exact_m);
    EXPECT_NEAR(right.y_m, -left.y_m, exact_m);
    EXPECT_NEAR(right.yaw_rad, -left.yaw_rad, exact_m);
}

TEST(StoppingPath, BackwardWithALeftTurnEndsBehindToTheRight) {
    const Pose2 end = end_of({}, {-0.15, 0.6}, 1.0);
    EXPECT_LT(end.x_m, -0.05);
    EXPECT_LT(end.y_m, -0.01);
    EXPECT_GT(end.yaw_rad, 0.1);
}

TEST(StoppingPath, ASteadyArcLiesOnItsCircle) {
    // No change of speed until the stop; the radius is v / omega = 0.8 m about (0, 0.8).
    for (const Pose2& pose : path_of(RobotModel(), {0.4, 0.5}, {0.4, 0.5}, 2.0)) {
        if (pose.yaw_rad > 0.5 * 2.05) break;  // it begins to brake at 2.1 s
        EXPECT_NEAR(pose.x_m, 0.8 * std::sin(pose.yaw_rad), 1e-4);
        EXPECT_NEAR(pose.y_m, 0.8 * (1 - std::cos(pose.yaw_rad)), 1e-4);
    }
}

TEST(StoppingPath, OnTheSpotItTurnsByTheDelayAndByTheBrakingOfTheTurn) {
    for (const double omega_radps : {0.8, -0.8}) {
        const std::vector<Pose2> path = path_of(RobotModel(), {0.0, omega_radps}, {}, 0.0);
        for (const Pose2& pose : path) EXPECT_LT(std::hypot(pose.x_m, pose.y_m), exact_m);
        const double turn_rad = 0.8 * 0.1 + 0.8 * 0.8 / (2 * 2.0);
        EXPECT_NEAR(path.back().yaw_rad, std::copysign(turn_rad, omega_radps), exact_m);
    }
}

TEST(StoppingPath, CommandsOnTheirWayTakeEffectFirst) {
    RobotModel robot;
    robot.delay_s = 0.5;
    // A command sent 0.4 s ago takes effect in 0.1 s and lasts 0.4 s, until the stop takes effect.
    const std::deque<TimedCommand> sent = {{-0.4, {0.4, 0.0}}};
    const Pose2 end = stopping_path(robot, {}, sent, 0.0, {0.0, {}}, 0.0).back();
    EXPECT_NEAR(end.x_m, 0.5 * 0.5 * 0.4 * 0.4 + 0.2 * 0.2 / 2, exact_m);
}

TEST(StoppingPath, TheLastOfTheCommandsOnTheirWayCounts) {
    RobotModel robot;
    robot.delay_s = 0.5;
    const std::deque<TimedCommand> sent = {{-0.4, {0.0, 0.6}}, {-0.2, {0.0, -0.6}}};
    const double yaw_rad = stopping_path(robot, {}, sent, 0.0, {0.0, {}}, 0.0).back().yaw_rad;
    // From 0.1 s at 2 rad/s2 up to 0.4 rad/s; from 0.3 s down to 0 at 0.5 s.
    EXPECT_NEAR(yaw_rad, 0.5 * 2.0 * 0.2 * 0.2 + 0.5 * 2.0 * 0.2 * 0.2, exact_m);
}

TEST(StoppingPath, TheTimeOfDayDoesNotMatter) {
    const std::deque<TimedCommand> sent = {{999.95, {0.4, 0.0}}};
    const Pose2 later = stopping_path(RobotModel(), {}, sent, 1000.0, {1000.0, {0.2, 0.3}}, 0.5).back();
    const Pose2 now =
        stopping_path(RobotModel(), {}, {{-0.05, {0.4, 0.0}}}, 0.0, {0.0, {0.2, 0.3}}, 0.5).back();
    EXPECT_NEAR(later.x_m, now.x_m, exact_m);
    EXPECT_NEAR(later.yaw_rad, now.yaw_rad, exact_m);
}

TEST(StoppingPath, ARobotThatStandsAndIsToldToStopStays) {
    const std::vector<Pose2> path = path_of(RobotModel(), {}, {}, 0.5);
    ASSERT_EQ(path.size(), 1U);
    EXPECT_EQ(path.front().x_m, 0.0);
    EXPECT_EQ(path.front().yaw_rad, 0.0);
}

TEST(StoppingPath, FromPoseToPoseNoCornerMovesMuchMoreThanTheStep) {
    const RobotModel robot;
    for (const double step_m : {0.01, 0.02, 0.1}) {
        for (const MotionCommand& command :
             {MotionCommand{0.4, 0.0}, MotionCommand{0.4, 0.9}, MotionCommand{0.0, -0.9}}) {
            const std::vector<Pose2> path = path_of(robot, {}, command, 2.0, step_m);
            ASSERT_GT(path.size(), 3U);
            const double tick_m = 0.01 * (std::abs(command.v_mps) + std::abs(command.omega_radps) * 0.33);
            for (std::size_t i = 1; i < path.size(); ++i) {
                for (const Vector2d& corner : robot.footprint_m) {
                    const double moved_m =
                        (transform(path[i], corner) - transform(path[i - 1], corner)).norm();
                    EXPECT_LE(moved_m, step_m + tick_m);
                }
            }
        }
    }
}

}  // namespace
}  // namespace flownav::nav
