#include "flownav/mapping/rim_memory.h"

#include <gtest/gtest.h>

#include "flownav/mapping/local_map.h"
#include "flownav/testing/contact_scans.h"
#include "obstacle_sets.h"

namespace flownav::mapping {
namespace {

using Eigen::Vector2d;
using testing::occupancy;
using testing::occupied_cells;

/// Both maps of one drive.
struct Maps {
    void insert(const ObstacleSet& set) {
        local.insert(set);
        global.insert(set);
    }
    /// Probability that a place of the map is occupied, by the map in which it is less.
    double occupied(const Vector2d& p_m, const Pose2& T_map_robot = {}) {
        local.redraw(T_map_robot);
        const Vector2d p = transform(inverse(T_map_robot), p_m);
        return std::min(occupancy(local.grid(), p.x(), p.y()), occupancy(global.grid(), p_m.x(), p_m.y()));
    }

    LocalMap local{MapParams{}};
    GlobalMap global{MapParams{}};
};

const Vector2d rim_m(1.25, -0.05);

/// A robot at x_m that sees the floor end at the rim, 0.2 m wide.
ObstacleSet drop_seen_from(double x_m, double timestamp_s = 0.0) {
    ContactScan scan = testing::open_scan();
    scan.step = 0.01;
    scan.first = -20;
    const double ahead_m = rim_m.x() - x_m;
    testing::block(scan, -0.1 / ahead_m, 0.1 / ahead_m, ahead_m, BeamCause::Drop);
    return {timestamp_s, {x_m, 0.0, 0.0}, {}, {}, scan};
}

/// A robot at x_m that sees floor at the rim and around it.
ObstacleSet floor_seen_from(double x_m, double timestamp_s = 0.0) {
    const double ahead_m = rim_m.x() - x_m;
    return {timestamp_s, {x_m, 0.0, 0.0}, {}, {{{ahead_m - 0.3, 0.0}, {ahead_m + 0.3, 0.0}, 0.4}}};
}

TEST(Rims, OneSightOfADropIsAnObstacleForEveryUserOfTheMaps) {
    Maps maps;
    maps.insert(drop_seen_from(0.0));
    EXPECT_GT(maps.occupied(rim_m), 1.0 - OccupancyLimits().plan_certain_below);
    EXPECT_GT(maps.occupied({1.25, 0.05}), 0.9);
    EXPECT_LT(maps.occupied({1.25, 0.25}), 0.6);
    EXPECT_LT(maps.occupied({1.45, -0.05}), 0.6);
}

TEST(Rims, ADropToTheRightLiesToTheRight) {
    for (const double side : {1.0, -1.0}) {
        ContactScan scan = testing::open_scan();
        testing::block(scan, side * 0.3 - 0.03, side * 0.3 + 0.03, 1.55, BeamCause::Drop);
        Maps maps;
        maps.insert({0.0, {}, {}, {}, scan});
        EXPECT_GT(maps.occupied({1.55, -0.45 * side}), 0.9);
        EXPECT_LT(maps.occupied({1.55, 0.45 * side}), 0.6);
    }
}

TEST(Rims, ADropStaysWhenItIsSeenNoMore) {
    Maps maps;
    maps.insert(drop_seen_from(0.0));
    for (int i = 1; i < 200; ++i)
        maps.insert({0.5 * i, {0.8, 0.0, 1.0}, {}, {{{0.5, 0.0}, {0.6, 0.0}, 0.1}}});
    EXPECT_GT(maps.occupied(rim_m), 0.9);
    for (int i = 1; i < 50; ++i)
        maps.insert({100.0 + i, {-50.0, 0.0, 0.0}, {}, {{{0.5, 0.0}, {9.0, 0.0}, 9.0}}});
    EXPECT_GT(maps.occupied(rim_m), 0.9) << "the robot was elsewhere";
}

TEST(Rims, FloorSeenFromFartherAwayRemovesNone) {
    Maps maps;
    maps.insert(drop_seen_from(0.0));
    for (int i = 1; i < 100; ++i) maps.insert(floor_seen_from(-1.0, i));
    EXPECT_GT(maps.occupied(rim_m), 0.9);
}

TEST(Rims, FloorSeenFromAsNearInSeveralCyclesRemovesADrop) {
    Maps maps;
    maps.insert(drop_seen_from(0.0));
    for (int i = 1; i < 6; ++i) {
        maps.insert(floor_seen_from(0.1, 0.1 * i));
        EXPECT_GT(maps.occupied(rim_m), 0.9) << i;
    }
    maps.insert(floor_seen_from(0.1, 0.6));
    EXPECT_LT(maps.occupied(rim_m), 0.5);
    for (int i = 7; i < 10; ++i) maps.insert(floor_seen_from(0.1, 0.1 * i));
    EXPECT_LT(maps.occupied(rim_m), 0.35);
}

TEST(Rims, EverySightOfADropBeginsTheCountAnew) {
    Maps maps;
    for (int i = 0; i < 10; ++i) {
        maps.insert(drop_seen_from(0.0, i));
        for (int k = 0; k < 5; ++k) maps.insert(floor_seen_from(0.1, i + 0.1 * k));
    }
    EXPECT_GT(maps.occupied(rim_m), 0.9);
}

TEST(Rims, FloorBesideADropRemovesNone) {
    Maps maps;
    maps.insert(drop_seen_from(0.0));
    for (int i = 1; i < 50; ++i) {
        ObstacleSet set = floor_seen_from(0.1, 0.1 * i);
        set.ground.front().near_m.y() = set.ground.front().far_m.y() = 0.6;
        maps.insert(set);
    }
    EXPECT_GT(maps.occupied(rim_m), 0.9);
}

TEST(Rims, NoneGetsLostInTheLocalMapHoweverTheRobotTurns) {
    LocalMap map{MapParams{}};
    map.insert(drop_seen_from(0.0));
    for (double yaw_rad = 0.0; yaw_rad < 6.3; yaw_rad += 0.05) {
        const Pose2 T_map_robot{0.3, -0.1, yaw_rad};
        map.redraw(T_map_robot);
        for (const double x_m : {1.225, 1.275}) {  // where the cells of the guard's memory have their middles
            for (const double y_m : {-0.075, -0.025, 0.025, 0.075}) {
                const Vector2d p = transform(inverse(T_map_robot), {x_m, y_m});
                EXPECT_GT(occupancy(map.grid(), p.x(), p.y()), 0.9) << yaw_rad << " " << x_m << " " << y_m;
            }
        }
        EXPECT_LE(occupied_cells(map.grid()), 12) << yaw_rad;
    }
}

TEST(Rims, ARimOfTheGlobalMapStaysWhereItIsWhenTheMapGrows) {
    GlobalMap map{MapParams{}};
    map.insert(drop_seen_from(0.0));
    const int before = occupied_cells(map.grid());
    map.insert({1.0, {-15.03, 7.01, 0.0}, {}, {}, testing::free_scan(3.0)});
    EXPECT_EQ(occupied_cells(map.grid()), before);
    EXPECT_GT(occupancy(map.grid(), rim_m.x(), rim_m.y()), 0.9);
}

}  // namespace
}  // namespace flownav::mapping
