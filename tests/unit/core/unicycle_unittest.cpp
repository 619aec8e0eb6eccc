#include "flownav/core/unicycle.h"

#include <gtest/gtest.h>

namespace flownav {
namespace {

constexpr double step_s = 0.1;

RobotModel model() {
    RobotModel robot;
    robot.accel_mps2 = 0.5;
    robot.brake_mps2 = 1.0;
    robot.alpha_radps2 = 2.0;
    return robot;
}

double speed_after(double v_mps, double wanted_mps) {
    return motion_after(model(), {v_mps, 0.0}, {wanted_mps, 0.0}, step_s).v_mps;
}

double turn_after(double omega_radps, double wanted_radps) {
    return motion_after(model(), {0.0, omega_radps}, {0.0, wanted_radps}, step_s).omega_radps;
}

TEST(PoseAfter, AQuarterTurnEndsAtTheEndOfTheQuarterCircle) {
    for (const double side : {1.0, -1.0}) {
        const Pose2 pose = pose_after({1.0, side * 0.5}, M_PI);  // radius 2 m
        EXPECT_NEAR(pose.x_m, 2.0, 1e-12);
        EXPECT_NEAR(pose.y_m, side * 2.0, 1e-12);
        EXPECT_NEAR(pose.yaw_rad, side * M_PI / 2, 1e-12);
    }
}

TEST(PoseAfter, StraightIsTheLimitOfWideArcs) {
    EXPECT_EQ(pose_after({-0.5, 0.0}, 2.0).x_m, -1.0);
    EXPECT_NEAR(pose_after({-0.5, 1e-10}, 2.0).x_m, -1.0, 1e-12);
    EXPECT_NEAR(pose_after({-0.5, 1e-8}, 2.0).x_m, -1.0, 1e-12);
}

TEST(MotionAfter, SpeedsUpAndBrakesAtTheirOwnLimits) {
    for (const double side : {1.0, -1.0}) {
        EXPECT_NEAR(speed_after(side * 0.2, side * 1.0), side * 0.25, 1e-12);
        EXPECT_NEAR(speed_after(side * 1.0, side * 0.2), side * 0.9, 1e-12);
        EXPECT_NEAR(speed_after(0.0, side * 1.0), side * 0.05, 1e-12);
    }
}

TEST(MotionAfter, ReversingBrakes) {
    for (const double side : {1.0, -1.0})
        EXPECT_NEAR(speed_after(side * 0.3, side * -0.9), side * 0.2, 1e-12);
}

TEST(MotionAfter, ReachesACommandWithinOneStepExactly) {
    EXPECT_EQ(speed_after(0.37, 0.4), 0.4);
    EXPECT_EQ(speed_after(0.07, 0.0), 0.0);
    EXPECT_EQ(turn_after(-0.07, 0.1), 0.1);
}

TEST(MotionAfter, TurnsChangeAtOneLimitEitherWay) {
    for (const double side : {1.0, -1.0}) {
        EXPECT_NEAR(turn_after(side * 0.2, side * 0.9), side * 0.4, 1e-12);
        EXPECT_NEAR(turn_after(side * 0.9, 0.0), side * 0.7, 1e-12);
    }
}

}  // namespace
}  // namespace flownav
