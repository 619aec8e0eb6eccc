#include "flownav/nav/motion_model.h"

#include <gtest/gtest.h>

namespace flownav::nav {
namespace {

TEST(MotionModel, AQuarterTurnToTheLeftEndsLeftOfTheStart) {
    const double radius_m = 2.0;
    const Pose2 pose = pose_after({1.0, 1.0 / radius_m}, M_PI / 2 * radius_m);
    EXPECT_NEAR(pose.x_m, radius_m, 1e-12);
    EXPECT_NEAR(pose.y_m, radius_m, 1e-12);
    EXPECT_NEAR(pose.yaw_rad, M_PI / 2, 1e-12);
}

TEST(MotionModel, BackwardGoesBackward) {
    EXPECT_NEAR(pose_after({-0.5, 0.0}, 2.0).x_m, -1.0, 1e-12);
}

TEST(MotionModel, TheSpeedThatStopsInTimeInvertsTheStoppingDistance) {
    const RobotModel robot;
    for (const double v_mps : {0.05, 0.4, 1.0, 2.0}) {
        EXPECT_NEAR(stoppable_speed_mps(robot, stopping_distance_m(robot, v_mps)), v_mps, 1e-12);
    }
    EXPECT_EQ(stoppable_speed_mps(robot, -0.1), 0.0);
}

}  // namespace
}  // namespace flownav::nav
