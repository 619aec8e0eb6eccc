#include <gtest/gtest.h>

#include "flownav/mapping/fusion.h"
#include "obstacle_sets.h"

namespace flownav {
namespace {

using Eigen::Vector2d;
using testing::occupancy;
using testing::occupied_cells;
using testing::set_seeing;

TEST(LocalMap, KeepsTheRobotAtItsCentre) {
    LocalMap map({});
    const Pose2 T_map_robot{30.0, -20.0, 1.0};
    for (int i = 0; i < 2; ++i) map.insert(set_seeing(30.0, -18.0, T_map_robot));
    EXPECT_NEAR(map.grid().getXMin(), -map.grid().getXMax(), 0.11);
    EXPECT_NEAR(map.grid().getYMin(), -map.grid().getYMax(), 0.11);
    EXPECT_NEAR(map.grid().getXMax(), 5.0, 0.11);
    const Vector2d p = transform(inverse(T_map_robot), {30.0, -18.0});
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
    EXPECT_EQ(occupied_cells(map.grid()), 1);
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
    map.insert({0.0, {1.0, 0.0, 0.0}, {}, {}});  // a metre on it lies inside
    EXPECT_EQ(occupied_cells(map.grid()), 1);
}

}  // namespace
}  // namespace flownav
