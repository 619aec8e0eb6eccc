#include "flownav/sim/vehicle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace flownav::sim {
namespace {

RobotModel prompt_robot() {
    RobotModel robot;
    robot.delay_s = 0.0;
    robot.accel_mps2 = 1e6;
    robot.brake_mps2 = 1e6;
    robot.alpha_radps2 = 1e6;
    return robot;
}

TEST(Vehicle, StandsWhereItStartsUntilItIsCommanded) {
    Vehicle vehicle(RobotModel{}, {1.0, 2.0, 0.3});
    vehicle.advance(5.0);
    EXPECT_EQ(vehicle.pose().x_m, 1.0);
    EXPECT_EQ(vehicle.pose().y_m, 2.0);
    EXPECT_EQ(vehicle.pose().yaw_rad, 0.3);
    EXPECT_EQ(vehicle.motion().v_mps, 0.0);
}

TEST(Vehicle, DrivesForwardAlongItsHeading) {
    Vehicle vehicle(prompt_robot(), {0.0, 0.0, M_PI / 2});
    vehicle.command(0.0, {0.4, 0.0});
    vehicle.advance(2.0);
    EXPECT_NEAR(vehicle.pose().x_m, 0.0, 1e-9);
    EXPECT_NEAR(vehicle.pose().y_m, 0.8, 1e-9);
}

TEST(Vehicle, TurnsLeftForPositiveOmega) {
    Vehicle vehicle(prompt_robot(), {});
    vehicle.command(0.0, {0.0, 0.5});
    vehicle.advance(1.0);
    EXPECT_NEAR(vehicle.pose().yaw_rad, 0.5, 1e-9);
}

TEST(Vehicle, DrivesBackwardForNegativeSpeed) {
    Vehicle vehicle(prompt_robot(), {});
    vehicle.command(0.0, {-0.1, 0.0});
    vehicle.advance(1.0);
    EXPECT_NEAR(vehicle.pose().x_m, -0.1, 1e-9);
}

TEST(Vehicle, FollowsACircleExactly) {
    Vehicle vehicle(prompt_robot(), {});
    vehicle.command(0.0, {0.4, 0.8});
    vehicle.advance(2.5);
    EXPECT_NEAR(vehicle.pose().x_m, 0.5 * std::sin(2.0), 1e-9);
    EXPECT_NEAR(vehicle.pose().y_m, 0.5 * (1.0 - std::cos(2.0)), 1e-9);
    EXPECT_NEAR(vehicle.pose().yaw_rad, 2.0, 1e-9);
}

TEST(Vehicle, ObeysAfterTheDelay) {
    RobotModel robot = prompt_robot();
    robot.delay_s = 0.25;
    Vehicle vehicle(robot, {});
    vehicle.command(0.0, {0.4, 0.0});
    vehicle.advance(0.25);
    EXPECT_EQ(vehicle.pose().x_m, 0.0);
    vehicle.advance(1.25);
    EXPECT_NEAR(vehicle.pose().x_m, 0.4, 1e-9);
}

TEST(Vehicle, SpeedsUpAndBrakesAtItsLimits) {
    RobotModel robot;
    robot.delay_s = 0.0;
    Vehicle vehicle(robot, {});
    vehicle.command(0.0, {0.4, 0.0});
    vehicle.advance(0.4);
    EXPECT_NEAR(vehicle.motion().v_mps, 0.2, 1e-3);  // 0.5 m/s^2
    vehicle.advance(2.0);
    EXPECT_EQ(vehicle.motion().v_mps, 0.4);
    const double before_m = vehicle.pose().x_m;
    vehicle.command(2.0, {});
    vehicle.advance(3.0);
    EXPECT_EQ(vehicle.motion().v_mps, 0.0);
    EXPECT_NEAR(vehicle.pose().x_m - before_m, 0.4 * 0.4 / 2, 1e-3);  // 1 m/s^2
}

TEST(Vehicle, BrakesBeforeItReverses) {
    RobotModel robot;
    robot.delay_s = 0.0;
    Vehicle vehicle(robot, {});
    vehicle.command(0.0, {0.4, 0.0});
    vehicle.advance(2.0);
    vehicle.command(2.0, {-0.15, 0.0});
    vehicle.advance(2.4);
    EXPECT_NEAR(vehicle.motion().v_mps, 0.0, 2e-3);
    vehicle.advance(2.6);
    EXPECT_NEAR(vehicle.motion().v_mps, -0.1, 2e-3);
}

TEST(Vehicle, ClipsCommandsToItsSpeeds) {
    const RobotModel robot = prompt_robot();
    Vehicle vehicle(robot, {});
    vehicle.command(0.0, {9.0, -9.0});
    vehicle.advance(1.0);
    EXPECT_EQ(vehicle.motion().v_mps, robot.v_max_mps);
    EXPECT_EQ(vehicle.motion().omega_radps, -robot.omega_max_radps);
    vehicle.command(1.0, {-9.0, 9.0});
    vehicle.advance(2.0);
    EXPECT_EQ(vehicle.motion().v_mps, -robot.v_back_mps);
}

TEST(Vehicle, RefusesWhatIsNotANumber) {
    Vehicle vehicle(RobotModel{}, {});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(vehicle.command(0.0, {nan, 0.0}), std::invalid_argument);
    EXPECT_THROW(vehicle.command(0.0, {0.0, nan}), std::invalid_argument);
}

Pose2 driven(double step_s, bool advance_first) {
    Vehicle vehicle(RobotModel{}, {});
    double next_s = 0.0;
    for (int tick = 0; tick < 30; ++tick) {
        const double time_s = tick * 0.1;
        for (; next_s < time_s; next_s += step_s) vehicle.advance(next_s);
        if (advance_first) vehicle.advance(time_s);
        vehicle.command(time_s, {0.1 * (tick % 5), 0.2 * (tick % 7 - 3)});
    }
    vehicle.advance(3.0004);
    return vehicle.pose();
}

TEST(Vehicle, DoesTheSameHoweverOftenItIsAdvanced) {
    const Pose2 rarely = driven(10.0, false);
    for (const double step_s : {0.1, 0.0003, 0.0333}) {
        for (const bool advance_first : {false, true}) {
            const Pose2 often = driven(step_s, advance_first);
            EXPECT_EQ(often.x_m, rarely.x_m) << step_s;
            EXPECT_EQ(often.y_m, rarely.y_m) << step_s;
            EXPECT_EQ(often.yaw_rad, rarely.yaw_rad) << step_s;
        }
    }
}

TEST(Vehicle, MovesOnInsideAStep) {
    Vehicle vehicle(prompt_robot(), {});
    vehicle.command(0.0, {0.4, 0.0});
    vehicle.advance(1.0005);
    EXPECT_NEAR(vehicle.pose().x_m, 0.4002, 1e-9);
    vehicle.advance(0.5);
    EXPECT_NEAR(vehicle.pose().x_m, 0.4002, 1e-9);
}

}  // namespace
}  // namespace flownav::sim
