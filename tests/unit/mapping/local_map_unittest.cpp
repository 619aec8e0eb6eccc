#include "flownav/mapping/local_map.h"

#include <gtest/gtest.h>

#include "obstacle_sets.h"

namespace flownav::mapping {
namespace {

using Eigen::Vector2d;
using testing::occupancy;
using testing::occupied_cells;
using testing::set_seeing;

TEST(LocalMap, KeepsTheRobotAtItsCentre) {
    LocalMap map({});
    const Pose2 T_map_robot{30.0, -20.0, 1.0};
    for (int i = 0; i < 2; ++i) map.insert(set_seeing(30.05, -17.95, T_map_robot));
    EXPECT_NEAR(map.grid().getXMin(), -map.grid().getXMax(), 0.11);
    EXPECT_NEAR(map.grid().getYMin(), -map.grid().getYMax(), 0.11);
    EXPECT_NEAR(map.grid().getXMax(), 5.0, 0.11);
    const Vector2d p = transform(inverse(T_map_robot), {30.05, -17.95});
    EXPECT_GT(occupancy(map.grid(), p.x(), p.y()), 0.7);
}

TEST(LocalMap, WhatIsLeftOfTheRobotHasPositiveY) {
    LocalMap map({});
    for (int i = 0; i < 2; ++i) map.insert({0.0, {3, 4, 2.0}, {testing::point_at(1.05, 0.75)}, {}});
    EXPECT_GT(occupancy(map.grid(), 1.05, 0.75), 0.7);
}

TEST(LocalMap, ASetThatIsMovedByTheRobotsMotionLandsOnTheSamePlaceOfTheWorld) {
    LocalMap map({});
    const Vector2d thing(2.25, 0.45);
    const Pose2 later{0.7, 0.2, 0.5};
    map.insert(set_seeing(thing.x(), thing.y(), {}, 0.0));
    map.insert(set_seeing(thing.x(), thing.y(), later, 1.0));
    EXPECT_LE(occupied_cells(map.grid()), 2);  // one cell, rotated
    const Vector2d p = transform(inverse(later), thing);
    EXPECT_GT(occupancy(map.grid(), p.x(), p.y()), 0.7);
}

TEST(LocalMap, ForgetsWhatIsOlderThanItsMemory) {
    LocalMap map({});
    for (int i = 0; i < 3; ++i) map.insert(set_seeing(2.25, 0.45, {}, 0.1 * i));
    map.insert({6.0, {}, {}, {}});
    EXPECT_EQ(occupied_cells(map.grid()), 1);
    map.insert({6.25, {}, {}, {}});
    EXPECT_EQ(occupied_cells(map.grid()), 0);
    EXPECT_NEAR(occupancy(map.grid(), 2.25, 0.45), 0.5, 0.01);
}

TEST(LocalMap, LeavesOutWhatLiesOutsideItsEdges) {
    MapParams params;
    params.size_m = 4.0;
    LocalMap map(params);
    for (int i = 0; i < 3; ++i) map.insert(set_seeing(2.5, 0.0, {}));
    EXPECT_EQ(occupied_cells(map.grid()), 0);
    map.insert({0.0, {1.0, 0.0, 0.0}, {}, {}});  // with the robot a metre ahead, the obstacle lies inside
    EXPECT_EQ(occupied_cells(map.grid()), 1);
}

TEST(LocalMap, NoObstacleGetsLostHoweverTheRobotTurns) {
    LocalMap map({});
    for (int i = 0; i < 3; ++i) map.insert(set_seeing(2.25, 0.45, {}, 0.1 * i));
    for (double yaw_rad = 0.0; yaw_rad < 6.3; yaw_rad += 0.05) {
        map.redraw({0.3, -0.1, yaw_rad});
        EXPECT_GE(occupied_cells(map.grid()), 1) << yaw_rad;
        EXPECT_LE(occupied_cells(map.grid()), 3) << yaw_rad;
    }
}

TEST(LocalMap, WhatLeftTheMapAndCameBackIsNotForgottenTwice) {
    MapParams params;
    params.size_m = 4.0;
    LocalMap map(params);
    const ObstacleSet there = set_seeing(0.85, 0.05, {}, 0.0);
    const Pose2 far_away{6.4, 0.0, 0.0};  // the same cells of the ring buffer
    map.insert(there);
    for (int i = 0; i < 3; ++i) map.insert(set_seeing(7.25, 0.05, far_away, 1.0));
    for (int i = 0; i < 3; ++i) map.insert(set_seeing(0.85, 0.05, {}, 2.0));
    map.insert({6.5, {}, {}, {}});  // clears the first cells
    const double before = occupancy(map.grid(), 0.85, 0.05);
    map.insert({7.5, {}, {}, {}});  // clears the far cells
    EXPECT_GT(before, 0.8);
    EXPECT_EQ(occupancy(map.grid(), 0.85, 0.05), before);
}

const GroundPatch floor_ahead{{1.0, 0.0}, {3.0, 0.0}, 0.6};

TEST(LocalMap, WhatWasSeenToBeFreeForLongBecomesOccupiedSoonToo) {
    LocalMap map({});
    for (int i = 0; i < 30; ++i) map.insert({0.2 * i, {}, {}, {floor_ahead}});
    EXPECT_LT(occupancy(map.grid(), 2.05, 0.05), 0.35);
    for (int i = 30; i < 33; ++i) map.insert({0.2 * i, {}, {testing::point_at(2.05, 0.05)}, {floor_ahead}});
    EXPECT_GT(occupancy(map.grid(), 2.05, 0.05), 0.65);
    EXPECT_LT(occupancy(map.grid(), 2.45, 0.05), 0.35);
}

TEST(LocalMap, AThinLegOnTheCornerOfFourCellsIsNotOutvotedByTheFloorBesideIt) {
    LocalMap map({});
    for (int i = 0; i < 30; ++i) map.insert({0.2 * i, {}, {}, {floor_ahead}});
    for (int i = 0; i < 12; ++i) {
        const double x_m = i % 2 == 0 ? 1.98 : 2.02;
        const double y_m = i % 4 < 2 ? 0.08 : 0.12;
        map.insert({6.0 + 0.2 * i, {}, {testing::point_at(x_m, y_m)}, {floor_ahead}});
    }
    EXPECT_GT(occupancy(map.grid(), 1.95, 0.05), 0.6);
    EXPECT_GT(occupancy(map.grid(), 2.05, 0.15), 0.6);
}

}  // namespace
}  // namespace flownav::mapping
