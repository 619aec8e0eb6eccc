#include "flownav/drive/simulated_drive.h"

#include <gtest/gtest.h>

namespace flownav::drive {
namespace {

using Eigen::Vector2d;

sim::Solid post(double x_m, double y_m) {
    sim::Solid solid;
    solid.name = "post";
    solid.shape = sim::Cylinder{0.1, 1.0};
    solid.T_world_solid.translation() << x_m, y_m, 0.5;
    return solid;
}

/// A drive of three metres straight ahead, past a post, with the lidar.
SimulatedDriveOptions round_a_post() {
    SimulatedDriveOptions options;
    options.world.solids = {post(1.6, 0.05)};
    options.goals_m = {{3.0, 0.0}};
    options.sensor = SensorKind::Lidar;
    options.lidar.beams = 91;
    options.lidar.rate_hz = 10.0;
    options.lidar.range_max_m = 4.0;
    options.config.map.resolution_m = 0.05;
    options.config.map.size_m = 8.0;
    options.timeout_s = 60.0;
    return options;
}

DriveResult drive(const SimulatedDriveOptions& options) {
    DriveObserver nobody;
    return simulate_drive(options, nobody);
}

TEST(SimulatedDrive, RoundsAPostWithEitherNavigator) {
    for (const char* name : {"lanes", "reactive"}) {
        SimulatedDriveOptions options = round_a_post();
        options.config.navigation.navigator = name;
        const DriveResult result = drive(options);
        EXPECT_EQ(result.outcome, Outcome::Reached) << result.why;
        EXPECT_GT(result.min_clearance_m, 0.03);
        EXPECT_GT(result.path_m, 2.4);
        EXPECT_LT(result.path_m, 4.0);
    }
}

TEST(SimulatedDrive, TheSameOptionsGiveTheSameDrive) {
    const SimulatedDriveOptions options = round_a_post();
    const DriveResult a = drive(options);
    const DriveResult b = drive(options);
    ASSERT_EQ(a.samples.size(), b.samples.size());
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
        EXPECT_EQ(a.samples[i].T_world_robot.x_m, b.samples[i].T_world_robot.x_m);
        EXPECT_EQ(a.samples[i].command.omega_radps, b.samples[i].command.omega_radps);
    }
}

TEST(SimulatedDrive, AWallAllRoundIsNeverTouched) {
    SimulatedDriveOptions options = round_a_post();
    for (int i = 0; i < 40; ++i) {
        const double angle = i * 2.0 * M_PI / 40;
        options.world.solids.push_back(post(1.5 * std::cos(angle), 1.5 * std::sin(angle)));
    }
    options.timeout_s = 40.0;
    const DriveResult result = drive(options);
    EXPECT_TRUE(result.outcome == Outcome::Blocked || result.outcome == Outcome::Timeout);
    EXPECT_GT(result.min_clearance_m, 0.0);
}

TEST(SimulatedDrive, WhatFallsOnTheRobotIsACollision) {
    SimulatedDriveOptions options = round_a_post();
    sim::Solid mover = post(0.0, 0.0);
    mover.name = "cart";
    sim::TimedPose from{0.0, mover.T_world_solid};
    sim::TimedPose to{4.0, mover.T_world_solid};
    from.T_world_solid.translation() << 0.0, 4.0, 0.5;
    to.T_world_solid.translation() << 0.3, 0.0, 0.5;
    mover.script = {from, to};
    options.world.solids.push_back(mover);
    options.goals_m = {{0.0, -20.0}};
    // The robot does not move out of the way.
    options.navigator = [](double, const MotionCommand&) { return std::nullopt; };
    const DriveResult result = drive(options);
    EXPECT_EQ(result.outcome, Outcome::Collision);
    EXPECT_EQ(result.why, "touched cart");
    EXPECT_EQ(result.contact_speed_mps, 0.0);
}

sim::GroundPiece level_ground(const std::string& name, double from_m, double to_m, double height_m) {
    sim::GroundPiece piece;
    piece.name = name;
    piece.T_world_ground.translation() << (from_m + to_m) / 2, 0.0, height_m;
    piece.size_m = {to_m - from_m, 6.0};
    return piece;
}

/// Straight ahead without asking the sensor, which does not see the ground.
SimulatedDriveOptions straight_over(const std::vector<sim::GroundPiece>& ground) {
    SimulatedDriveOptions options = round_a_post();
    options.world.solids.clear();
    options.world.ground = ground;
    options.timeout_s = 20.0;
    return options;
}

TEST(SimulatedDrive, ARobotWhoseOutlinePassesAnEdgeHasFallen) {
    const DriveResult result = drive(straight_over({level_ground("step", 1.5, 3.5, -0.17)}));
    EXPECT_EQ(result.outcome, Outcome::Fell);
    EXPECT_STREQ(to_string(result.outcome), "fell");
    EXPECT_NE(result.why.find("0.17 m deep"), std::string::npos) << result.why;
    EXPECT_NEAR(result.samples.back().T_world_robot.x_m, 1.25, 0.02);
    EXPECT_GT(result.contact_speed_mps, 0.2);
}

TEST(SimulatedDrive, AKerbThatIsTouchedIsACollisionAndAThresholdIsDrivenOver) {
    const DriveResult kerb = drive(straight_over({level_ground("kerb", 1.5, 3.5, 0.05)}));
    EXPECT_EQ(kerb.outcome, Outcome::Collision);
    EXPECT_EQ(kerb.why, "touched kerb");
    const DriveResult threshold = drive(straight_over({level_ground("threshold", 1.5, 1.6, 0.02)}));
    EXPECT_EQ(threshold.outcome, Outcome::Reached) << threshold.why;
}

TEST(SimulatedDrive, OnARampTheTruthHasHeightAndTilt) {
    const double lean_rad = 0.1;
    sim::GroundPiece ramp = level_ground("ramp", 1.0, 5.0, 2.0 * std::tan(lean_rad));
    ramp.T_world_ground.rotate(Eigen::AngleAxisd(-lean_rad, Eigen::Vector3d::UnitY()));
    ramp.size_m.x() = 4.0 / std::cos(lean_rad);
    const DriveResult result = drive(straight_over({ramp}));
    EXPECT_EQ(result.outcome, Outcome::Reached) << result.why;
    const DriveSample& last = result.samples.back();
    EXPECT_NEAR(last.T_flat_robot.translation().z(), (last.T_world_robot.x_m - 1.0) * std::tan(lean_rad),
                2e-3);
    EXPECT_NEAR(last.T_flat_robot.linear()(2, 0), std::sin(lean_rad), 2e-3);
    EXPECT_TRUE(result.samples.front().T_flat_robot.matrix().isIdentity(1e-9));
}

TEST(SimulatedDrive, ANavigatorThatHangsStopsTheRobotAndDrivesOnAfterwards) {
    SimulatedDriveOptions options = round_a_post();
    options.navigator = [](double time_s, const MotionCommand& proposed) {
        return time_s > 3.0 && time_s < 6.0 ? std::nullopt : std::optional(proposed);
    };
    const DriveResult result = drive(options);
    EXPECT_EQ(result.outcome, Outcome::Reached);
    const auto silent = [](const nav::GuardEvent& e) {
        return e.reason == nav::GuardReason::NavigatorSilent;
    };
    EXPECT_TRUE(std::any_of(result.stops.begin(), result.stops.end(), silent));
}

TEST(SimulatedDrive, ANavigatorThatDrivesStraightAtAPostIsStopped) {
    SimulatedDriveOptions options = round_a_post();
    options.timeout_s = 12.0;
    options.navigator = [](double, const MotionCommand&) { return MotionCommand{0.4, 0.0}; };
    const DriveResult result = drive(options);
    EXPECT_EQ(result.outcome, Outcome::Timeout);
    EXPECT_EQ(result.stops.back().reason, nav::GuardReason::ObstacleAhead);
    EXPECT_GT(result.min_clearance_m, 0.0);
    EXPECT_LT(result.min_clearance_m, 0.3);
}

}  // namespace
}  // namespace flownav::drive
