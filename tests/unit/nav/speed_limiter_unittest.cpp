#include "reactive/speed_limiter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "course.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

constexpr double front_m = 0.25;  // of the default footprint; its rear is equally far behind
constexpr double period_s = 0.2;
constexpr double margin_m = 0.05;  // stop_margin_m, plus the addition for MRPT's paths

COccupancyGridMap2D free_map() {
    return Course().local_map({});
}

void fill(COccupancyGridMap2D& map, const Vector2d& low_m, const Vector2d& high_m, float p_free) {
    for (int y = map.y2idx(low_m.y()); y <= map.y2idx(high_m.y()); ++y)
        for (int x = map.x2idx(low_m.x()); x <= map.x2idx(high_m.x()); ++x) map.setCell(x, y, p_free);
}

/// A wall across the path; its nearest cells have their centres at `x_m` (forward > 0, behind < 0).
COccupancyGridMap2D wall_at(double x_m) {
    COccupancyGridMap2D map = free_map();
    const double beyond_m = x_m + std::copysign(0.2, x_m);
    fill(map, {std::min(x_m, beyond_m), -2.0}, {std::max(x_m, beyond_m), 2.0}, 0.1F);
    return map;
}

RobotModel fast_robot() {
    RobotModel robot;
    robot.v_max_mps = robot.v_back_mps = 1.5;
    return robot;
}

/// A footprint with a long nose: 0.6 m ahead, but only 0.28 m elsewhere.
RobotModel long_nose() {
    RobotModel robot;
    robot.footprint_m = {{0.6, 0.1}, {-0.2, 0.2}, {-0.2, -0.2}, {0.6, -0.1}};
    return robot;
}

Situation on(const COccupancyGridMap2D& map, const MotionCommand& motion = {}) {
    Situation situation;
    situation.motion = motion;
    situation.local_map = &map;
    return situation;
}

Decision limit(const COccupancyGridMap2D& map, const MotionCommand& command,
               const MotionCommand& motion = {}) {
    return SpeedLimiter(fast_robot(), LaneParams(), period_s).limit(on(map, motion), command);
}

/// Distance until the robot stands: delay of the command, and braking.
double stopping_way_m(double v_mps) {
    return 0.1 * std::abs(v_mps) + v_mps * v_mps / 2.0;
}

TEST(SpeedLimiter, OverFreeGroundACommandPassesAsItIs) {
    for (const MotionCommand& command :
         {MotionCommand{1.5, 0.0}, MotionCommand{0.5, 0.6}, MotionCommand{0.5, -0.6},
          MotionCommand{-0.3, 0.0}, MotionCommand{0.0, 0.9}, MotionCommand{0.0, -0.9}}) {
        const Decision decision = limit(free_map(), command);
        EXPECT_EQ(decision.command.v_mps, command.v_mps);
        EXPECT_EQ(decision.command.omega_radps, command.omega_radps);
        EXPECT_FALSE(decision.stuck);
        EXPECT_EQ(decision.why, "drives");
    }
}

TEST(SpeedLimiter, TheSpeedBeforeAWallIsTheOneThatStopsBeforeIt) {
    for (const double direction : {1.0, -1.0}) {
        for (const double wall_m : {1.025, 1.525}) {
            const Decision decision = limit(wall_at(direction * wall_m), {1.5 * direction, 0.0});
            EXPECT_GT(decision.command.v_mps * direction, 0.3);
            const double before_wall_m = wall_m - front_m - margin_m - stopping_way_m(decision.command.v_mps);
            EXPECT_NEAR(before_wall_m, LaneParams().standoff_m, 0.03);
            EXPECT_NEAR(decision.free_m, wall_m - front_m - margin_m, 0.03);
            EXPECT_EQ(decision.why, "slows for an obstacle");
        }
    }
}

TEST(SpeedLimiter, AWallOnTheOtherSideDoesNotSlow) {
    EXPECT_EQ(limit(wall_at(-0.6), {1.5, 0.0}).command.v_mps, 1.5);
    EXPECT_EQ(limit(wall_at(0.6), {-1.5, 0.0}).command.v_mps, -1.5);
}

TEST(SpeedLimiter, SlowedItKeepsToTheCurve) {
    for (const double side : {1.0, -1.0}) {
        COccupancyGridMap2D map = free_map();
        fill(map, {0.9, 0.5 * side - 0.15}, {1.2, 0.5 * side + 0.15}, 0.1F);
        const Decision decision = limit(map, {1.5, 1.5 * side});
        EXPECT_GT(decision.command.v_mps, 0.1);
        EXPECT_LT(decision.command.v_mps, 1.4);
        EXPECT_NEAR(decision.command.omega_radps, decision.command.v_mps * side, 1e-9);
        EXPECT_EQ(limit(map, {1.5, -1.5 * side}).command.v_mps, 1.5) << "away from it";
    }
}

TEST(SpeedLimiter, ItCanStopBeforeGroundThatWasNotSeen) {
    COccupancyGridMap2D map = free_map();
    fill(map, {1.5, -4.0}, {4.9, 4.0}, 0.5F);
    const Decision decision = limit(map, {1.5, 0.0});
    // The robot may stop with its bumper 0.4 m before unseen ground, because no camera sees nearer ground.
    EXPECT_NEAR(stopping_way_m(decision.command.v_mps), 1.5 - front_m - LaneParams().bumper_m, 0.15);
    EXPECT_EQ(decision.why, "slows for unseen ground");
    EXPECT_EQ(limit(map, {-1.5, 0.0}).command.v_mps, -1.5) << "away from it";
}

TEST(SpeedLimiter, OverGroundThatWasNotSeenItCrawls) {
    COccupancyGridMap2D map = free_map();
    map.fill(0.5F);
    for (const double v_mps : {1.5, -1.5}) {
        const Decision decision = limit(map, {v_mps, 0.0});
        EXPECT_NEAR(decision.command.v_mps, std::copysign(LaneParams().unseen_mps, v_mps), 1e-9);
        EXPECT_FALSE(decision.stuck);
    }
    EXPECT_EQ(limit(map, {0.1, 0.0}).command.v_mps, 0.1) << "slow enough";
}

TEST(SpeedLimiter, AMovingRobotRightBeforeAWallStops) {
    for (const double direction : {1.0, -1.0}) {
        const MotionCommand motion{0.6 * direction, 0.0};
        const Decision decision = limit(wall_at(direction * (front_m + 0.2)), motion, motion);
        EXPECT_EQ(decision.command.v_mps, 0.0);
        EXPECT_EQ(decision.command.omega_radps, 0.0);
        EXPECT_FALSE(decision.stuck) << "it moves";
        EXPECT_EQ(decision.why, "stops for an obstacle");
    }
}

TEST(SpeedLimiter, AStandingRobotRightBeforeAWallMayOnlyDriveAway) {
    for (const double direction : {1.0, -1.0}) {
        const COccupancyGridMap2D map = wall_at(direction * (front_m + 0.025));
        EXPECT_EQ(limit(map, {0.5 * direction, 0.0}).command.v_mps, 0.0);
        EXPECT_LT(limit(map, {-0.5 * direction, 0.0}).command.v_mps * direction, -0.1);
    }
}

TEST(SpeedLimiter, OnAFineMapAStandingRobotRightBeforeAWallIsStuckOnlyTowardIt) {
    Course course;
    course.cell_m = 0.02;
    COccupancyGridMap2D map = course.local_map({});
    fill(map, {front_m + 0.03, -2.0}, {front_m + 0.2, 2.0}, 0.1F);
    EXPECT_TRUE(limit(map, {0.5, 0.0}).stuck);
    EXPECT_EQ(limit(map, {0.5, 0.0}).why, "an obstacle is right ahead");
    EXPECT_FALSE(limit(map, {-0.5, 0.0}).stuck);
}

TEST(SpeedLimiter, TurnsMoreSlowlyTowardWhatACornerWouldTouch) {
    for (const double side : {1.0, -1.0}) {
        COccupancyGridMap2D map = free_map();
        map.setCell(map.x2idx(0.12), map.y2idx(0.27 * side), 0.1F);
        const double toward_radps = limit(map, {0.0, 0.9 * side}).command.omega_radps * side;
        EXPECT_GT(toward_radps, 0.1);
        EXPECT_LT(toward_radps, 0.8);
        EXPECT_EQ(limit(map, {0.0, -0.9 * side}).command.omega_radps, -0.9 * side) << "away from it";
        const MotionCommand turning{0.0, 0.9 * side};
        map.setCell(map.x2idx(0.12), map.y2idx(0.22 * side), 0.1F);
        EXPECT_EQ(limit(map, turning, turning).command.omega_radps, 0.0) << "too near for any turn";
    }
}

TEST(SpeedLimiter, AWayPointBehindIsTurnedToUntilItIsAhead) {
    const SpeedLimiter speed_limiter(RobotModel(), LaneParams(), period_s);
    for (const double side : {1.0, -1.0}) {
        const auto at = [&](double bearing_rad) {
            return Vector2d(std::cos(bearing_rad), side * std::sin(bearing_rad));
        };
        EXPECT_TRUE(speed_limiter.wants_to_turn(at(2.0), {}));
        EXPECT_FALSE(speed_limiter.wants_to_turn(at(1.8), {}));
        EXPECT_TRUE(speed_limiter.wants_to_turn(at(0.6), {0.0, 0.5 * side})) << "it goes on";
        EXPECT_FALSE(speed_limiter.wants_to_turn(at(0.6), {0.0, -0.5 * side})) << "turning the other way";
        EXPECT_FALSE(speed_limiter.wants_to_turn(at(0.6), {0.3, 0.5 * side})) << "driving";
        EXPECT_FALSE(speed_limiter.wants_to_turn(at(0.4), {0.0, 0.5 * side})) << "ahead";
    }
}

TEST(SpeedLimiter, TurnsTheShortWayRound) {
    const SpeedLimiter speed_limiter(RobotModel(), LaneParams(), period_s);
    const COccupancyGridMap2D map = free_map();
    const Decision left = speed_limiter.turn_to(on(map), {-1.0, 0.5});
    EXPECT_GT(left.command.omega_radps, 0.2);
    EXPECT_EQ(left.command.v_mps, 0.0);
    const Decision right = speed_limiter.turn_to(on(map), {-1.0, -0.5});
    EXPECT_LT(right.command.omega_radps, -0.2);
    EXPECT_FALSE(left.stuck || right.stuck);
}

TEST(SpeedLimiter, TurnsTheLongWayRoundWhenTheShortOneIsNotFreeAndIsStuckWithoutEither) {
    const SpeedLimiter speed_limiter(long_nose(), LaneParams(), period_s);
    for (const double side : {1.0, -1.0}) {
        COccupancyGridMap2D map = free_map();
        map.setCell(map.x2idx(0.01), map.y2idx(0.45 * side), 0.1F);  // in the path of the nose
        const Vector2d waypoint_m(-1.0, 0.7 * side);
        const Decision long_way = speed_limiter.turn_to(on(map), waypoint_m);
        EXPECT_LT(long_way.command.omega_radps * side, -0.2);
        EXPECT_FALSE(long_way.stuck);
        map.setCell(map.x2idx(0.01), map.y2idx(-0.45 * side), 0.1F);
        const Decision none = speed_limiter.turn_to(on(map), waypoint_m);
        EXPECT_TRUE(none.stuck);
        EXPECT_EQ(none.command.omega_radps, 0.0);
    }
}

TEST(SpeedLimiter, StopsBeforeItTurnsOnTheSpot) {
    const SpeedLimiter speed_limiter(RobotModel(), LaneParams(), period_s);
    const COccupancyGridMap2D map = free_map();
    for (const double v_mps : {0.3, -0.15}) {
        const Decision decision = speed_limiter.turn_to(on(map, {v_mps, 0.0}), {-1.0, 0.5});
        EXPECT_EQ(decision.command.v_mps, 0.0);
        EXPECT_EQ(decision.command.omega_radps, 0.0);
        EXPECT_FALSE(decision.stuck);
    }
}

}  // namespace
}  // namespace flownav::nav
