#include "local/can_still_stop.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/sim/random.h"
#include "guard_drive.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

constexpr double field_reach_m = 0.11;
constexpr double front_m = 0.25;  // of the default footprint

bool allows(const RobotModel& robot, const Vector2d& obstacle_m, const MotionCommand& motion,
            const MotionCommand& command) {
    const FootprintField field(robot.footprint_m, field_reach_m);
    return can_still_stop(robot, field, {obstacle_m}, motion, command, LaneParams());
}

bool allows(const Vector2d& obstacle_m, const MotionCommand& motion, const MotionCommand& command) {
    return allows(RobotModel(), obstacle_m, motion, command);
}

/// Least distance of the outline to a point, of a robot that moves steadily, is told `command` for a period
/// and then to stop: in steps of a millisecond, to its model.
double nearest_m(const RobotModel& robot, const Vector2d& obstacle_m, const MotionCommand& motion,
                 const MotionCommand& command) {
    ModelRobot truth(robot);
    truth.command(0.0, motion);
    truth.advance(2.0);  // moves with `motion` by now
    const double now_s = truth.time_s();
    const Pose2 T_world_now = truth.pose();
    truth.command(now_s, command);
    truth.command(now_s + LaneParams().period_s + robot.delay_s, {});
    double nearest = 1e9;
    while (truth.time_s() < now_s + 3.0) {
        truth.advance(truth.time_s() + 0.01);
        const Pose2 T_now_there = compose(inverse(T_world_now), truth.pose());
        nearest = std::min(nearest,
                           signed_distance_m(robot.footprint_m, transform(inverse(T_now_there), obstacle_m)));
    }
    return nearest;
}

TEST(ObstaclesNear, AreTheMiddlesOfOccupiedCellsWithinTheDistance) {
    COccupancyGridMap2D map(-2.0F, 2.0F, -1.0F, 1.0F, 0.05F);
    map.fill(0.9F);
    const auto set = [&](double x_m, double y_m, float p) { map.setCell(map.x2idx(x_m), map.y2idx(y_m), p); };
    set(0.61, -0.31, 0.1F);  // in cell 0.60..0.65, -0.35..-0.30
    set(-0.42, 0.77, 0.1F);
    set(0.3, 0.3, 0.4F);  // perhaps an obstacle
    set(0.3, -0.3, 0.5F);
    set(1.6, 0.0, 0.1F);  // too far away
    const std::vector<Vector2d> found = obstacles_near(map, kinds_of(map, mapping::OccupancyLimits()), 1.5);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_LT((found[0] - Vector2d(0.625, -0.325)).norm(), 1e-5);
    EXPECT_LT((found[1] - Vector2d(-0.425, 0.775)).norm(), 1e-5);
}

TEST(CanStillStop, StraightTheLimitIsTheWayOfTheDelaysThePeriodAndOfBraking) {
    RobotModel robot;
    robot.v_max_mps = robot.v_back_mps = 1.0;
    robot.delay_s = 0.2;
    for (const double v_mps : {1.0, 0.4, -1.0}) {
        const double speed = std::abs(v_mps);
        const double way_m =
            speed * (2 * robot.delay_s + LaneParams().period_s) + speed * speed / (2 * robot.brake_mps2);
        const double limit_m = front_m + way_m + LaneParams().stop_margin_m;
        const double coarse_m = 0.05 * speed + 0.01;  // it looks ahead in steps of 50 ms
        const auto allows_at = [&](double distance_m) {
            return allows(robot, {std::copysign(distance_m, v_mps), 0.05}, {v_mps, 0.0}, {v_mps, 0.0});
        };
        EXPECT_TRUE(allows_at(limit_m + coarse_m)) << v_mps;
        EXPECT_FALSE(allows_at(limit_m - coarse_m)) << v_mps;
    }
}

TEST(CanStillStop, AMovingRobotToldToStopNeedsTheWayOfTheDelayAndOfBraking) {
    const double way_m = 0.4 * 0.1 + 0.4 * 0.4 / 2;
    EXPECT_TRUE(allows({front_m + way_m + 0.06, 0.0}, {0.4, 0.0}, {}));
    EXPECT_FALSE(allows({front_m + way_m - 0.02, 0.0}, {0.4, 0.0}, {}));
}

TEST(CanStillStop, AnArcToTheLeftMeetsWhatStandsLeftAndOneToTheRightWhatStandsRight) {
    for (const double side : {1.0, -1.0}) {
        const Vector2d beside(0.42, 0.26 * side);
        EXPECT_FALSE(allows(beside, {0.4, 0.9 * side}, {0.4, 0.9 * side}));
        EXPECT_TRUE(allows(beside, {0.4, -0.9 * side}, {0.4, -0.9 * side}));
        const Vector2d ahead(0.44, 0.23 * side);  // just passed straight ahead
        EXPECT_FALSE(allows(ahead, {0.4, 0.0}, {0.4, 0.9 * side})) << "turning begins only now";
        EXPECT_TRUE(allows(ahead, {0.4, 0.0}, {0.4, -0.9 * side}));
    }
}

TEST(CanStillStop, BackwardOnlyWhatStandsBehindMatters) {
    const Vector2d behind(-front_m - 0.06, 0.0);
    EXPECT_FALSE(allows(behind, {-0.15, 0.0}, {-0.15, 0.0}));
    EXPECT_TRUE(allows(-behind, {-0.15, 0.0}, {-0.15, 0.0}));
    EXPECT_TRUE(allows(behind, {0.15, 0.0}, {0.15, 0.0}));
}

TEST(CanStillStop, TurningOnTheSpotACornerMeetsWhatStandsOnItsSide) {
    for (const double side : {1.0, -1.0}) {
        const Vector2d beside(0.15, 0.27 * side);  // 22 degrees from the front corner, 80 from the rear one
        EXPECT_FALSE(allows(beside, {0.0, 0.9 * side}, {0.0, 0.9 * side}));
        EXPECT_TRUE(allows(beside, {0.0, -0.9 * side}, {0.0, -0.9 * side}));
    }
}

TEST(CanStillStop, WhatStandsBesideTheRobotWithinTheMarginDoesNotHoldIt) {
    for (const double side : {1.0, -1.0}) {
        const Vector2d beside(0.0, 0.21 * side);
        EXPECT_TRUE(allows(beside, {0.4, 0.0}, {0.4, 0.0}));
        EXPECT_TRUE(allows(beside, {-0.15, 0.0}, {-0.15, 0.0}));
    }
    EXPECT_TRUE(allows({0.0, 0.0}, {0.4, 0.0}, {0.4, 0.0})) << "a cell below the robot";
}

TEST(CanStillStop, WhatItAllowsIsNotTouchedAndWhatIsPassedFarAwayIsAllowed) {
    sim::HashRandom random(7);
    int allowed = 0, refused = 0;
    for (int i = 0; i < 800; ++i) {
        RobotModel robot;
        robot.v_max_mps = random.uniform(0.3, 0.8);
        robot.delay_s = random.uniform(0.0, 0.25);
        robot.brake_mps2 = random.uniform(0.5, 2.0);
        const MotionCommand motion{random.uniform(-0.15, robot.v_max_mps), random.uniform(-0.9, 0.9)};
        const MotionCommand command{random.uniform(-0.15, robot.v_max_mps), random.uniform(-0.9, 0.9)};
        const Vector2d obstacle_m(random.uniform(-0.4, 0.8), random.uniform(-0.35, 0.35));
        if (signed_distance_m(robot.footprint_m, obstacle_m) < 0.05) continue;
        const double distance_m = nearest_m(robot, obstacle_m, motion, command);
        const bool is_allowed = allows(robot, obstacle_m, motion, command);
        if (is_allowed) {
            EXPECT_GT(distance_m, 0.0) << i;
        }
        if (distance_m > LaneParams().stop_margin_m + 0.05) {
            EXPECT_TRUE(is_allowed) << i;
        }
        ++(is_allowed ? allowed : refused);
    }
    EXPECT_GT(allowed, 50);
    EXPECT_GT(refused, 50);
}

TEST(Reach, NothingFartherAwayThanItMatters) {
    const RobotModel robot;
    const FootprintField field(robot.footprint_m, field_reach_m);
    const double far_m = reach_m(robot, field, LaneParams()) + 0.001;
    EXPECT_LT(far_m, 1.0) << "it is of use";
    for (int i = 0; i < 72; ++i) {
        const Vector2d obstacle_m(far_m * std::cos(i * M_PI / 36), far_m * std::sin(i * M_PI / 36));
        for (const double omega_radps : {0.0, 0.9, -0.9}) {
            const MotionCommand fastest{robot.v_max_mps, omega_radps};
            EXPECT_TRUE(allows(obstacle_m, fastest, fastest)) << i;
        }
    }
}

TEST(CanStillStop, WhatItAllowsIsNotTouchedByAFastRobotEither) {
    for (const double v_mps : {1.0, 1.5, 2.0}) {
        RobotModel robot;
        robot.v_max_mps = v_mps;
        robot.accel_mps2 = 4.0;
        const MotionCommand fastest{v_mps, 0.0};
        const double way_m = v_mps * (2 * robot.delay_s + LaneParams().period_s) + v_mps * v_mps / 2;
        for (int mm = -100; mm <= 100; mm += 5) {
            const Vector2d obstacle_m(front_m + way_m + 0.001 * mm, 0.0);
            if (!allows(robot, obstacle_m, fastest, fastest)) continue;
            EXPECT_GT(nearest_m(robot, obstacle_m, fastest, fastest), 0.0)
                << v_mps << " m/s, " << mm << " mm";
        }
    }
}

TEST(Reach, OfARobotThatReactsSlowlyNothingFartherAwayMattersEither) {
    RobotModel robot;
    robot.v_max_mps = 1.5;
    robot.delay_s = 0.3;
    const FootprintField field(robot.footprint_m, field_reach_m);
    const double far_m = reach_m(robot, field, LaneParams()) + 0.001;
    const MotionCommand fastest{robot.v_max_mps, 0.0};
    EXPECT_TRUE(allows(robot, {far_m, 0.0}, fastest, fastest)) << far_m;
}

}  // namespace
}  // namespace flownav::nav
