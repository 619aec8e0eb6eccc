#include "flownav/sim/wheel_odometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flownav::sim {
namespace {

OdometryParams exact() {
    OdometryParams params;
    params.scale = 1.0;
    params.turn_scale = 1.0;
    params.way_noise_m = 0.0;
    params.turn_noise_rad = 0.0;
    return params;
}

/// Pose after `s_m` on a circle of radius 2 m to the left.
Pose2 on_circle(double s_m) {
    return {2.0 * std::sin(s_m / 2), 2.0 - 2.0 * std::cos(s_m / 2), wrap_angle(s_m / 2)};
}

TEST(WheelOdometry, WithoutErrorsIsTheTruth) {
    WheelOdometry wheels(exact());
    for (int i = 0; i <= 200; ++i) {
        const Pose2 odometry = wheels.update(on_circle(0.1 * i));
        EXPECT_NEAR(odometry.x_m, on_circle(0.1 * i).x_m, 1e-9);
        EXPECT_NEAR(odometry.y_m, on_circle(0.1 * i).y_m, 1e-9);
        EXPECT_NEAR(wrap_angle(odometry.yaw_rad - on_circle(0.1 * i).yaw_rad), 0.0, 1e-9);
    }
}

TEST(WheelOdometry, BeginsAtTheFirstTruePose) {
    WheelOdometry wheels(OdometryParams{});
    const Pose2 first = wheels.update({3.0, -1.0, 0.5});
    EXPECT_EQ(first.x_m, 3.0);
    EXPECT_EQ(first.y_m, -1.0);
    EXPECT_EQ(first.yaw_rad, 0.5);
}

TEST(WheelOdometry, ScalesWaysForwardAndBackward) {
    OdometryParams params = exact();
    params.scale = 1.02;
    WheelOdometry wheels(params);
    wheels.update({});
    EXPECT_NEAR(wheels.update({1.0, 0.0, 0.0}).x_m, 1.02, 1e-12);
    EXPECT_NEAR(wheels.update({-1.0, 0.0, 0.0}).x_m, -1.02, 1e-12);
}

TEST(WheelOdometry, ScalesTurnsAcrossTheBackwardDirection) {
    OdometryParams params = exact();
    params.turn_scale = 1.1;
    WheelOdometry wheels(params);
    wheels.update({0.0, 0.0, 3.0});
    EXPECT_NEAR(wheels.update({0.0, 0.0, -3.0}).yaw_rad, wrap_angle(3.0 + 1.1 * (2 * M_PI - 6.0)), 1e-9);
}

/// Standard deviation of distance and heading after 4 m, read in `steps` steps.
Eigen::Vector2d spread(int steps) {
    Eigen::Vector2d squares = Eigen::Vector2d::Zero();
    constexpr int runs = 400;
    for (int run = 0; run < runs; ++run) {
        OdometryParams params = exact();
        params.way_noise_m = 0.01;
        params.turn_noise_rad = 0.003;
        params.seed = static_cast<std::uint64_t>(run);
        WheelOdometry wheels(params);
        Pose2 last;
        for (int i = 0; i <= steps; ++i) last = wheels.update({4.0 * i / steps, 0.0, 0.0});
        squares += Eigen::Vector2d(std::pow(last.x_m - 4.0, 2), std::pow(last.yaw_rad, 2));
    }
    return (squares / runs).cwiseSqrt();
}

TEST(WheelOdometry, NoiseGrowsWithTheRootOfTheWayHoweverOftenTheWheelsAreRead) {
    for (const int steps : {1, 100}) {
        EXPECT_NEAR(spread(steps).x(), 0.02, 0.003) << steps;
        EXPECT_NEAR(spread(steps).y(), 0.006, 0.0009) << steps;
    }
}

TEST(WheelOdometry, StandsStillWithTheRobot) {
    WheelOdometry wheels(OdometryParams{});
    wheels.update({1.0, 1.0, 1.0});
    for (int i = 0; i < 100; ++i) EXPECT_EQ(wheels.update({1.0, 1.0, 1.0}).x_m, 1.0);
}

}  // namespace
}  // namespace flownav::sim
