#include "flownav/nav/pose_fusion.h"

#include <gtest/gtest.h>

namespace flownav::nav {
namespace {

/// A robot model without a practical speed limit.
const RobotModel fast = [] {
    RobotModel robot;
    robot.v_max_mps = 10.0;
    robot.omega_max_radps = 10.0;
    return robot;
}();

void expect_near(const Pose2& a, const Pose2& b, double tolerance = 1e-9) {
    EXPECT_NEAR(a.x_m, b.x_m, tolerance);
    EXPECT_NEAR(a.y_m, b.y_m, tolerance);
    EXPECT_NEAR(wrap_angle(a.yaw_rad - b.yaw_rad), 0.0, tolerance);
}

TEST(PoseFusion, StartsAtTheStartWhateverTheWheelsHaveCounted) {
    PoseFusion fusion(fast, {1.0, 2.0, 0.5});
    fusion.odometry(0.0, {7.0, -3.0, 2.0});
    expect_near(fusion.now(), {1.0, 2.0, 0.5});
}

TEST(PoseFusion, WithoutFlowItFollowsTheWheels) {
    PoseFusion fusion(fast);
    fusion.odometry(0.0, {});
    fusion.odometry(0.1, {0.1, 0.02, 0.3});
    expect_near(fusion.now(), {0.1, 0.02, 0.3});
    expect_near(fusion.at(0.05), {0.05, 0.01, 0.15});
}

TEST(PoseFusion, FlowReplacesWhatWheelsSayOfTheSameTime) {
    PoseFusion fusion(fast);
    for (int i = 0; i <= 10; ++i) {
        const double time_s = 0.1 * i;
        fusion.odometry(time_s, {0.12 * i, 0.0, -0.05 * i});  // slipping and skewed
        fusion.flow(time_s, Pose2{0.1 * i, 0.0, 0.0});
    }
    expect_near(fusion.now(), {1.0, 0.0, 0.0});
}

TEST(PoseFusion, AcrossALongGapOfTheFlowTheWheelsTellTheWay) {
    PoseFusion fusion(fast);
    fusion.odometry(0.0, {});
    fusion.flow(0.0, Pose2{});
    fusion.odometry(1.0, {0.5, 0.0, 0.0});
    fusion.flow(1.0, Pose2{0.1, 0.0, 0.0});  // its images were frozen most of the way
    expect_near(fusion.now(), {0.5, 0.0, 0.0});
}

TEST(PoseFusion, AStepThatNoRobotCanMakeCountsAsNone) {
    PoseFusion fusion{RobotModel()};  // 0.4 m/s
    fusion.odometry(0.0, {});
    fusion.odometry(0.1, {0.04, 0.0, 0.0});
    fusion.odometry(0.2, {3.0, 1.0, 0.5});
    expect_near(fusion.now(), {0.04, 0.0, 0.0});
    fusion.odometry(0.3, {3.0 + 0.04 * std::cos(0.5), 1.0 + 0.04 * std::sin(0.5), 0.5});
    expect_near(fusion.now(), {0.08, 0.0, 0.0});
    fusion.odometry(0.4, {3.0, 1.0, 2.5});
    EXPECT_NEAR(fusion.now().yaw_rad, 0.0, 1e-9);
}

TEST(PoseFusion, AJumpOfTheWheelsIsForgottenWithTheNextField) {
    PoseFusion fusion(fast);
    fusion.odometry(0.0, {});
    fusion.flow(0.0, Pose2{});
    fusion.odometry(0.1, {1.4, 0.0, 1.0});
    fusion.flow(0.1, Pose2{0.04, 0.0, 0.0});
    expect_near(fusion.now(), {0.04, 0.0, 0.0});
}

TEST(PoseFusion, WhileTheFlowIsLostTheWheelsGoOn) {
    PoseFusion fusion(fast);
    for (int i = 0; i <= 4; ++i) {
        fusion.odometry(0.1 * i, {0.1 * i, 0.0, 0.0});
        const bool lost = i == 2;
        fusion.flow(0.1 * i, lost ? std::nullopt : std::optional(Pose2{0.2 * i, 0.0, 0.0}));
    }
    expect_near(fusion.now(), {0.6, 0.0, 0.0});  // 0.2, two of 0.1, 0.2
}

TEST(PoseFusion, LateFlowCorrectsTheTimeItSpeaksOf) {
    PoseFusion fusion(fast);
    fusion.odometry(0.0, {});
    fusion.flow(0.0, Pose2{});
    fusion.odometry(0.1, {0.1, 0.0, 0.0});
    fusion.odometry(0.2, {0.2, 0.0, 0.0});
    fusion.flow(0.1, Pose2{0.09, 0.0, 0.0});
    expect_near(fusion.now(), {0.19, 0.0, 0.0});
}

}  // namespace
}  // namespace flownav::nav
