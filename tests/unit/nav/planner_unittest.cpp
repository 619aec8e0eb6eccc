#include "flownav/nav/planner.h"

#include <gtest/gtest.h>

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

constexpr float free_cell = 0.9F;
constexpr float occupied_cell = 0.1F;

/// A free map of 10 m x 10 m about the origin.
COccupancyGridMap2D free_map() {
    COccupancyGridMap2D map(-5.0F, 5.0F, -5.0F, 5.0F, 0.05F);
    map.fill(free_cell);
    return map;
}

void fill(COccupancyGridMap2D& map, const Vector2d& low_m, const Vector2d& high_m, float p_free) {
    for (int y = map.y2idx(low_m.y()); y <= map.y2idx(high_m.y()); ++y)
        for (int x = map.x2idx(low_m.x()); x <= map.x2idx(high_m.x()); ++x) map.setCell(x, y, p_free);
}

/// Adds a wall along y at x = 1, from y_low_m to y_high_m.
void build_wall(COccupancyGridMap2D& map, double y_low_m, double y_high_m) {
    fill(map, {1.0, y_low_m}, {1.1, y_high_m}, occupied_cell);
}

Plan plan_in(const COccupancyGridMap2D& map, const Vector2d& from_m, const Vector2d& goal_m) {
    return plan(map, from_m, goal_m, RobotModel(), PlanParams());
}

/// Smallest distance of a path to an occupied cell.
double clearance_m(const COccupancyGridMap2D& map, const Plan& plan) {
    double nearest = 100.0;
    for (const Vector2d& at : plan.path_m)
        nearest = std::min(nearest, static_cast<double>(map.computeClearance(
                                        static_cast<float>(at.x()), static_cast<float>(at.y()), 3.0F)));
    return nearest;
}

TEST(Planner, OverFreeGroundTheWayIsStraight) {
    const Plan plan = plan_in(free_map(), {-2.0, 0.0}, {2.0, 0.0});
    EXPECT_TRUE(plan.reaches_goal);
    EXPECT_NEAR(length_m(plan.path_m), 4.0, 0.1);
    EXPECT_NEAR(plan.way_point_m.x(), -2.0 + PlanParams().look_ahead_m, 0.1);
}

TEST(Planner, AWallIsPassedOnTheSideThatIsOpen) {
    for (const double side : {1.0, -1.0}) {
        COccupancyGridMap2D map = free_map();
        build_wall(map, side > 0 ? -5.0 : -1.0, side > 0 ? 1.0 : 5.0);  // open beyond y = 1 or y = -1
        PlanParams params;
        params.area_margin_m = 0.0;  // no ground outside the map
        const Plan way = plan(map, {-2.0, 0.0}, {3.0, 0.0}, RobotModel(), params);
        ASSERT_TRUE(way.reaches_goal);
        EXPECT_GT(way.way_point_m.y() * side, 0.0);
        EXPECT_GT(clearance_m(map, way), 0.25);
    }
}

TEST(Planner, AGapNarrowerThanTheRobotIsNoWay) {
    for (const double gap_m : {0.4, 0.7}) {
        COccupancyGridMap2D map = free_map();
        build_wall(map, -5.0, -gap_m / 2);
        build_wall(map, gap_m / 2, 5.0);
        PlanParams params;
        params.area_margin_m = 0.0;
        const Plan way = plan(map, {-2.0, 0.0}, {3.0, 0.0}, RobotModel(), params);
        EXPECT_EQ(way.reaches_goal, gap_m > 0.5);
    }
}

TEST(Planner, WithoutAWayThePathEndsNearTheGoal) {
    COccupancyGridMap2D map = free_map();
    build_wall(map, -5.0, 5.0);
    PlanParams params;
    params.area_margin_m = 0.0;
    const Plan way = plan(map, {-2.0, 0.0}, {3.0, 0.0}, RobotModel(), params);
    EXPECT_FALSE(way.reaches_goal);
    EXPECT_NEAR(way.path_m.back().x(), 1.0 - 0.27, 0.1);
    EXPECT_NEAR(way.path_m.back().y(), 0.0, 0.1);
}

TEST(Planner, AWayThatASingleSightClosedIsLookedAtBeforeALongDetourIsMade) {
    for (const bool is_certain : {false, true}) {
        for (const double end_m : {-1.5, 4.5}) {  // of the wall, which leaves a short or a long way around
            COccupancyGridMap2D map = free_map();
            fill(map, {1.0, -5.0}, {1.1, end_m}, is_certain ? 0.05F : 0.3F);
            PlanParams params;
            params.area_margin_m = 0.0;
            const Plan way = plan(map, {-2.0, -3.0}, {3.0, -3.0}, RobotModel(), params);
            ASSERT_TRUE(way.reaches_goal);
            EXPECT_EQ(length_m(way.path_m) > 5.5, is_certain || end_m < 2.0) << end_m;
        }
    }
}

TEST(Planner, SeenGroundIsPreferredToUnseen) {
    COccupancyGridMap2D map = free_map();
    fill(map, {-1.0, -1.0}, {1.0, 5.0}, 0.5F);
    const Plan way = plan_in(map, {-3.0, 0.0}, {3.0, 0.0});
    ASSERT_TRUE(way.reaches_goal);
    const auto unseen = [](const Vector2d& p) { return std::abs(p.x()) < 0.9 && p.y() > -0.9; };
    EXPECT_EQ(std::count_if(way.path_m.begin(), way.path_m.end(), unseen), 0);
}

TEST(Planner, ARobotTooNearToAWallIsLedOut) {
    COccupancyGridMap2D map = free_map();
    build_wall(map, -3.0, 3.0);
    const Plan way = plan_in(map, {0.85, 0.0}, {-3.0, 0.0});
    EXPECT_TRUE(way.reaches_goal);
    EXPECT_LT(way.way_point_m.x(), 0.7);
}

TEST(Planner, AGoalFarOutsideTheMapIsReachable) {
    const Plan plan = plan_in(free_map(), {0.0, 0.0}, {0.0, 30.0});
    EXPECT_TRUE(plan.reaches_goal);
    EXPECT_NEAR(plan.path_m.back().y(), 30.0, 0.1);
}

TEST(Planner, TheWayPointStandsInSightRoundACorner) {
    COccupancyGridMap2D map = free_map();
    build_wall(map, -5.0, 0.8);
    PlanParams params;
    params.area_margin_m = 0.0;
    const Vector2d from(0.4, 0.0);
    const Plan way = plan(map, from, {1.8, 0.0}, RobotModel(), params);
    ASSERT_TRUE(way.reaches_goal);
    EXPECT_LT(way.way_point_m.x(), 1.3);  // still before the wall
    EXPECT_GT(way.way_point_m.y(), 0.6);
}

TEST(Planner, TheWayPointIsAlwaysSomeWayAhead) {
    COccupancyGridMap2D map = free_map();
    for (double x = -2.0; x < 3.0; x += 0.5) fill(map, {x, 0.55}, {x + 0.1, 0.6}, occupied_cell);
    for (double x = -1.75; x < 3.0; x += 0.5) fill(map, {x, -0.6}, {x + 0.1, -0.55}, occupied_cell);
    for (double x = -1.5; x < 2.0; x += 0.07) {
        const Vector2d from(x, 0.05 * std::sin(9.0 * x));
        EXPECT_GT((plan_in(map, from, {3.0, 0.0}).way_point_m - from).norm(), 0.4) << x;
    }
}

TEST(Planner, TheInscribedRadiusIsTheNearestEdge) {
    EXPECT_NEAR(inscribed_radius_m({{0.5, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.5, -0.2}}), 0.2, 1e-12);
}

}  // namespace
}  // namespace flownav::nav
