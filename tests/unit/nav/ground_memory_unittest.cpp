#include "flownav/nav/ground_memory.h"

#include <gtest/gtest.h>

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

const Pose2 here;

COccupancyGridMap2D silent_map() {
    COccupancyGridMap2D map(-3.0F, 3.0F, -3.0F, 3.0F, 0.1F);
    map.fill(0.5F);
    return map;
}

COccupancyGridMap2D map_with(const Vector2d& at_m, float p_free) {
    COccupancyGridMap2D map = silent_map();
    map.setPos(static_cast<float>(at_m.x()), static_cast<float>(at_m.y()), p_free);
    return map;
}

/// Remembered state of a place with an obstacle, after maps that no longer show it.
Ground after(const Vector2d& obstacle_m, double silent_s, const Pose2& T_map_robot = here) {
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(map_with(obstacle_m, 0.1F), 0.0, here);
    for (int i = 1; i * 0.25 <= silent_s; ++i) memory.note(silent_map(), i * 0.25, T_map_robot);
    return memory.at(obstacle_m, silent_s);
}

TEST(GroundMemory, WhatWentAwayBeforeTheCameraIsSoonForgotten) {
    EXPECT_EQ(after({1.05, 0.05}, 9.0), Ground::Occupied);
    EXPECT_EQ(after({1.05, 0.05}, 11.0), Ground::Unknown);
}

TEST(GroundMemory, WhatStandsBesideOrBehindTheRobotIsRememberedAMinute) {
    for (const Vector2d& at_m : {Vector2d(0.25, 0.35), Vector2d(0.25, -0.35), Vector2d(-0.45, 0.05)}) {
        EXPECT_EQ(after(at_m, 55.0), Ground::Occupied) << at_m.transpose();
        EXPECT_EQ(after(at_m, 65.0), Ground::Unknown) << at_m.transpose();
    }
}

TEST(GroundMemory, WhereTheCameraLooksIsToldFromTheRobotsHeading) {
    const Pose2 turned_left{0.0, 0.0, M_PI_2};
    EXPECT_EQ(after({0.05, 1.05}, 11.0, turned_left), Ground::Unknown);
    EXPECT_EQ(after({1.05, 0.05}, 11.0, turned_left), Ground::Occupied);
}

TEST(GroundMemory, GroundThatIsSeenFreeIsNoObstacleAnyMore) {
    GroundMemory memory{GroundMemoryParams{}};
    const Vector2d beside_m(0.25, 0.35);
    memory.note(map_with(beside_m, 0.1F), 0.0, here);
    EXPECT_EQ(memory.note(map_with(beside_m, 0.9F), 1.0, here), 0) << "it was not unknown";
    EXPECT_EQ(memory.at(beside_m, 1.0), Ground::Free);
}

TEST(GroundMemory, TheLimitsOfTheGuardDecideWhatIsAnObstacleAndWhatIsFree) {
    const auto ground_of = [](float p_free, double obstacle_below, double free_above) {
        GroundMemoryParams params;
        params.limits.guard_obstacle_below = obstacle_below;
        params.limits.guard_free_above = free_above;
        GroundMemory memory(params);
        memory.note(map_with({1.05, 0.05}, p_free), 0.0, here);
        return memory.at(Vector2d(1.05, 0.05), 0.0);
    };
    EXPECT_EQ(ground_of(0.38F, 0.4, 0.55), Ground::Occupied);
    EXPECT_EQ(ground_of(0.38F, 0.35, 0.55), Ground::Unknown);
    EXPECT_EQ(ground_of(0.6F, 0.4, 0.55), Ground::Free);
    EXPECT_EQ(ground_of(0.6F, 0.4, 0.65), Ground::Unknown);
}

TEST(GroundMemory, WhereTheRobotStandsNothingElseDoes) {
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(map_with({0.05, 0.05}, 0.1F), 0.0, here);
    memory.mark_traversed({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}}, 1.0, here);
    EXPECT_EQ(memory.at(Vector2d(0.05, 0.05), 1.0), Ground::Driven);
}

/// A map whose first column and row are occupied has no data for the strip of cells outside it.
TEST(GroundMemory, BesideTheMapNothingIsKnown) {
    COccupancyGridMap2D map = silent_map();
    for (unsigned i = 0; i < map.getSizeX(); ++i) {
        const int last = static_cast<int>(map.getSizeX()) - 1;
        for (const int border : {0, last}) {
            map.setCell(border, static_cast<int>(i), 0.1F);
            map.setCell(static_cast<int>(i), border, 0.1F);
        }
    }
    GroundMemory memory{GroundMemoryParams{}};
    memory.note(map, 0.0, here);
    for (const double side : {-1.0, 1.0}) {
        EXPECT_EQ(memory.at(Vector2d(side * 2.98, 0.52), 0.0), Ground::Occupied) << side;
        EXPECT_EQ(memory.at(Vector2d(0.52, side * 2.98), 0.0), Ground::Occupied) << side;
        EXPECT_EQ(memory.at(Vector2d(side * 3.03, 0.52), 0.0), Ground::Unknown) << side;
        EXPECT_EQ(memory.at(Vector2d(0.52, side * 3.03), 0.0), Ground::Unknown) << side;
    }
}

}  // namespace
}  // namespace flownav::nav
