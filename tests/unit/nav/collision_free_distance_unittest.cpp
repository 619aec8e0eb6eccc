#include "flownav/nav/collision_free_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "course.h"

namespace flownav::nav {
namespace {

using mrpt::maps::COccupancyGridMap2D;

const FootprintField& field() {
    static const FootprintField made(RobotModel().footprint_m, 0.1);
    return made;
}

void fill(COccupancyGridMap2D& map, double x_low_m, double x_high_m, double y_low_m, double y_high_m,
          float p_free) {
    for (int y = map.y2idx(y_low_m); y <= map.y2idx(y_high_m); ++y)
        for (int x = map.x2idx(x_low_m); x <= map.x2idx(x_high_m); ++x) map.setCell(x, y, p_free);
}

COccupancyGridMap2D free_map() {
    return Course().local_map({});
}

CollisionFreeDistance way(const COccupancyGridMap2D& map, const MotionCommand& command) {
    return collision_free_distance(field(), map, command, CollisionFreeParams());
}

TEST(CollisionFreeDistance, AcrossFreeGroundItIsAsLongAsOneLooks) {
    EXPECT_EQ(way(free_map(), {0.4, 0.0}).occupied, CollisionFreeParams().length_m);
    EXPECT_EQ(way(free_map(), {0.4, 0.2}).unseen, CollisionFreeParams().length_m);
    EXPECT_EQ(way(free_map(), {0.0, 0.5}).occupied, M_PI);
}

TEST(CollisionFreeDistance, AWallAheadEndsItAtTheBumper) {
    COccupancyGridMap2D map = free_map();
    fill(map, 2.01, 2.2, -2.0, 2.0, 0.1F);
    // The middle of the first cell is at 2.025 m.
    EXPECT_NEAR(way(map, {0.4, 0.0}).occupied, 2.025 - 0.25 - 0.03, 0.03);
    EXPECT_EQ(way(map, {-0.1, 0.0}).occupied, CollisionFreeParams().length_m);
}

TEST(CollisionFreeDistance, AWallBehindEndsTheWayBack) {
    COccupancyGridMap2D map = free_map();
    fill(map, -1.2, -1.01, -2.0, 2.0, 0.1F);
    EXPECT_NEAR(way(map, {-0.1, 0.0}).occupied, 1.025 - 0.25 - 0.03, 0.03);
    EXPECT_EQ(way(map, {0.4, 0.0}).occupied, CollisionFreeParams().length_m);
}

TEST(CollisionFreeDistance, AnArcToTheLeftMeetsWhatStandsLeft) {
    COccupancyGridMap2D map = free_map();
    fill(map, 0.9, 1.1, 0.9, 1.1, 0.1F);
    EXPECT_LT(way(map, {0.5, 0.5}).occupied, 1.6);  // circle of 1 m about (0, 1)
    EXPECT_GT(way(map, {0.5, 0.5}).occupied, 1.0);
    EXPECT_EQ(way(map, {0.5, -0.5}).occupied, CollisionFreeParams().length_m);
    EXPECT_EQ(way(map, {0.5, 0.0}).occupied, CollisionFreeParams().length_m);
}

TEST(CollisionFreeDistance, TurningOnTheSpotEndsWhereACornerTouches) {
    COccupancyGridMap2D map = free_map();
    fill(map, 0.26, 0.29, 0.01, 0.04, 0.1F);  // right before the bumper, where no corner reaches farther
    const CollisionFreeDistance left = way(map, {0.0, 0.5});
    const CollisionFreeDistance right = way(map, {0.0, -0.5});
    EXPECT_GT(left.occupied, 0.1);
    EXPECT_LT(left.occupied, 1.0);
    EXPECT_GT(right.occupied, 0.1);
    EXPECT_LT(right.occupied, 1.0);
}

TEST(CollisionFreeDistance, UnseenGroundIsFoundBehindTheBlindStrip) {
    COccupancyGridMap2D map = free_map();
    fill(map, 0.25, 0.6, -0.3, 0.3, 0.5F);  // right before the bumper, out of view of any camera
    EXPECT_EQ(way(map, {0.4, 0.0}).unseen, CollisionFreeParams().length_m);
    fill(map, 1.5, 4.0, -1.0, 1.0, 0.5F);
    EXPECT_NEAR(way(map, {0.4, 0.0}).unseen, 1.5 - 0.25, 0.12);
    EXPECT_EQ(way(map, {0.4, 0.0}).occupied, CollisionFreeParams().length_m);
    EXPECT_EQ(way(map, {-0.4, 0.0}).unseen, CollisionFreeParams().length_m);
}

TEST(CollisionFreeDistance, AnUnseenSpeckDoesNotCount) {
    COccupancyGridMap2D map = free_map();
    fill(map, 1.5, 1.52, 0.0, 0.02, 0.5F);
    EXPECT_EQ(way(map, {0.4, 0.0}).unseen, CollisionFreeParams().length_m);
}

TEST(CollisionFreeDistance, WhatTheRobotStandsBesideDoesNotHoldIt) {
    COccupancyGridMap2D map = free_map();
    fill(map, -1.0, 1.0, 0.21, 0.24, 0.1F);  // a wall along its left side, within the margin
    EXPECT_EQ(way(map, {0.4, 0.0}).occupied, CollisionFreeParams().length_m);
    EXPECT_LT(way(map, {0.4, 0.4}).occupied, 0.3);
    EXPECT_EQ(way(map, {-0.1, 0.0}).occupied, CollisionFreeParams().length_m);
}

TEST(CollisionFreeDistance, KindsFollowTheLimits) {
    COccupancyGridMap2D map = free_map();
    map.setCell(0, 0, 0.1F);
    map.setCell(1, 0, 0.4F);
    map.setCell(2, 0, 0.5F);
    const std::vector<CellKind> kinds = kinds_of(map, mapping::OccupancyLimits());
    EXPECT_EQ(kinds[0], CellKind::Occupied);
    EXPECT_EQ(kinds[1], CellKind::Weak);
    EXPECT_EQ(kinds[2], CellKind::Unknown);
    EXPECT_EQ(kinds[3], CellKind::Free);
}

/// The robot is longer than the map around it.
TEST(CollisionFreeDistance, OfARobotThatReachesBeyondTheMapOnAllSides) {
    const Polygon large = {{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}};
    const FootprintField field_of_large(large, 0.1);
    COccupancyGridMap2D map(-1.0F, 1.0F, -1.0F, 1.0F, 0.05F);
    map.fill(0.9F);
    for (const MotionCommand& command :
         {MotionCommand{0.4, 0.0}, {-0.1, 0.0}, {0.4, 0.3}, {0.0, 0.5}, {0.0, -0.5}}) {
        const CollisionFreeDistance way =
            collision_free_distance(field_of_large, map, command, CollisionFreeParams());
        EXPECT_LE(way.unseen, 0.6) << "nobody saw what lies outside the map";
        EXPECT_GE(way.occupied, 1.0) << "nothing stands in the map";
    }
}

TEST(CollisionFreeDistance, WhatLiesOutsideTheMapIsUnseenOnEachSide) {
    COccupancyGridMap2D map(-1.0F, 1.0F, -1.0F, 1.0F, 0.05F);
    map.fill(0.9F);
    const double to_border_m = 1.0 - 0.25;
    EXPECT_NEAR(way(map, {0.4, 0.0}).unseen, to_border_m, 0.1);
    EXPECT_NEAR(way(map, {-0.1, 0.0}).unseen, to_border_m, 0.1);
}

TEST(FootprintField, FarAwayOrNowhereIsOutside) {
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    for (const double far_m : {1e3, 1e9, 1e300, nowhere}) {
        EXPECT_EQ(field().distance_m({far_m, 0.0}), field().reach_m());
        EXPECT_EQ(field().distance_m({0.0, far_m}), field().reach_m());
        EXPECT_EQ(field().distance_m({-far_m, -far_m}), field().reach_m());
    }
}

}  // namespace
}  // namespace flownav::nav
