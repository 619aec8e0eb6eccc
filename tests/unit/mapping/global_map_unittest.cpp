#include "flownav/mapping/global_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "flownav/mapping/local_map.h"
#include "obstacle_sets.h"

namespace flownav::mapping {
namespace {

using testing::occupancy;
using testing::occupied_cells;
using testing::point_at;
using testing::set_seeing;

constexpr double unknown = 0.5;
constexpr double tolerance = 0.01;  // a cell is one byte

TEST(GlobalMap, CellsNeverSeenStayUnknown) {
    GlobalMap map({});
    map.insert(set_seeing(1.25, 0.05, {}));
    EXPECT_NEAR(occupancy(map.grid(), 0.55, 0.05), unknown, tolerance);
    EXPECT_NEAR(occupancy(map.grid(), 1.55, 0.05), unknown, tolerance);
    EXPECT_NEAR(occupancy(map.grid(), -1.0, 1.0), unknown, tolerance);
}

TEST(GlobalMap, APointBecomesOccupiedAfterTwoCycles) {
    GlobalMap map({});
    map.insert(set_seeing(1.25, 0.05, {}));
    EXPECT_LT(occupancy(map.grid(), 1.25, 0.05), 0.66);
    map.insert(set_seeing(1.25, 0.05, {}));
    EXPECT_EQ(occupied_cells(map.grid()), 1);
    EXPECT_GT(occupancy(map.grid(), 1.25, 0.05), 0.7);
}

TEST(GlobalMap, ManyPointsOfOneCycleInOneCellCountOnce) {
    GlobalMap map({});
    ObstacleSet set = set_seeing(1.25, 0.05, {});
    for (int i = 0; i < 20; ++i) set.points.push_back(point_at(1.25, 0.05));
    map.insert(set);
    EXPECT_LT(occupancy(map.grid(), 1.25, 0.05), 0.66);
}

TEST(GlobalMap, APointOfUncertainRangeSaysLess) {
    GlobalMap map({});
    map.insert({0.0, {}, {point_at(1.25, 0.05, 0.01), point_at(1.25, 0.55, 0.2)}, {}});
    EXPECT_GT(occupancy(map.grid(), 1.25, 0.05), occupancy(map.grid(), 1.25, 0.55) + 0.05);
    EXPECT_GE(occupancy(map.grid(), 1.25, 0.55), unknown - tolerance);
}

TEST(GlobalMap, ConfirmedFloorBecomesFreeAllAlongItsPatch) {
    GlobalMap map({});
    for (int i = 0; i < 4; ++i) map.insert({0.0, {}, {}, {{{0.55, 0.05}, {1.55, 0.05}}}});
    for (int i = 0; i < 9; ++i) EXPECT_LT(occupancy(map.grid(), 0.65 + 0.1 * i, 0.05), 0.35);
    EXPECT_NEAR(occupancy(map.grid(), 1.0, 0.25), unknown, tolerance);
    EXPECT_NEAR(occupancy(map.grid(), 1.75, 0.05), unknown, tolerance);
}

TEST(GlobalMap, AnObstacleBeatsFloorInTheSameCell) {
    GlobalMap map({});
    const std::vector<GroundPatch> floor = {{{0.55, 0.05}, {1.25, 0.05}}, {{1.2, 0.05}, {1.3, 0.05}}};
    for (int i = 0; i < 3; ++i) map.insert({0.0, {}, {point_at(1.25, 0.05)}, floor});
    EXPECT_GT(occupancy(map.grid(), 1.25, 0.05), 0.7);
    EXPECT_LT(occupancy(map.grid(), 0.85, 0.05), 0.5);
}

TEST(GlobalMap, FloorSeenLaterClearsWhatIsGone) {
    GlobalMap map({});
    for (int i = 0; i < 3; ++i) map.insert(set_seeing(1.25, 0.05, {}));
    for (int i = 0; i < 10; ++i) map.insert({1.0, {}, {}, {{{1.15, 0.05}, {1.35, 0.05}}}});
    EXPECT_LT(occupancy(map.grid(), 1.25, 0.05), 0.5);
}

TEST(GlobalMap, OneThingSeenFromTwoPosesFallsInOneCell) {
    GlobalMap map({});
    map.insert(set_seeing(2.25, 0.45, {}));
    map.insert(set_seeing(2.25, 0.45, {0.7, -0.4, 0.6}));
    EXPECT_EQ(occupied_cells(map.grid()), 1);
    EXPECT_GT(occupancy(map.grid(), 2.25, 0.45), 0.7);
}

TEST(GlobalMap, LeftOfARobotThatLooksLeftIsBehindTheStart) {
    GlobalMap map({});
    for (int i = 0; i < 2; ++i) map.insert({0.0, {0, 0, M_PI / 2}, {point_at(0.05, 1.25)}, {}});
    EXPECT_GT(occupancy(map.grid(), -1.25, 0.05), 0.7);
}

TEST(GlobalMap, GrowsWithTheDriveAndKeepsWhatItHas) {
    GlobalMap map({});
    for (int i = 0; i < 2; ++i) map.insert(set_seeing(1.25, 0.05, {}));
    for (int i = 0; i < 2; ++i) map.insert(set_seeing(20.25, -10.45, {19.0, -10.0, 0.0}));
    EXPECT_EQ(occupied_cells(map.grid()), 2);
    EXPECT_GT(occupancy(map.grid(), 1.25, 0.05), 0.7);
    EXPECT_GT(occupancy(map.grid(), 20.25, -10.45), 0.7);
}

TEST(GlobalMap, TakesItsResolutionFromTheParameters) {
    MapParams params;
    params.resolution_m = 0.05;
    EXPECT_NEAR(GlobalMap(params).grid().getResolution(), 0.05, 1e-6);
}

TEST(GlobalMap, ARobotTooFarFromTheStartIsLeftOutAndCounted) {
    MapParams coarse;
    coarse.resolution_m = 2.0;
    GlobalMap map(coarse);
    map.insert(set_seeing(1.0, 1.0, {}));
    for (const double broken : {1e7, 1e300, std::numeric_limits<double>::quiet_NaN()})
        map.insert(set_seeing(broken, 1.0, {broken, -1e7, 0.0}));
    EXPECT_EQ(map.sets(), 4);
    EXPECT_EQ(map.sets_outside(), 3);
    EXPECT_LT(map.grid().getXMax(), 10.0);
}

/// At the finest resolution, 2000 m exceed the number of cells that MRPT can count.
TEST(GlobalMap, TheFinestMapEndsWhereItsCellsCanStillBeCounted) {
    MapParams fine;
    fine.resolution_m = 0.02;
    GlobalMap map(fine);
    EXPECT_NEAR(map.half_m(), 200.0, 1e-9);
    for (const double side : {-1.0, 1.0}) {
        const double x_m = side * 199.5;
        for (int i = 0; i < 2; ++i) map.insert(set_seeing(x_m, 0.05, {x_m - side, 0.0, 0.0}));
        EXPECT_GT(occupancy(map.grid(), x_m + 0.005, 0.055), 0.7) << side;
    }
    EXPECT_LE(map.grid().getSizeX(), 20001U);
    map.insert(set_seeing(250.0, 0.05, {249.0, 0.0, 0.0}));
    EXPECT_EQ(map.sets_outside(), 1);
}

TEST(LocalMap, APoseThatIsNoNumberOrFarAwayChangesNothing) {
    LocalMap map({});
    for (int i = 0; i < 2; ++i) map.insert(set_seeing(1.25, 0.05, {}));
    for (const double broken : {1e12, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        map.insert(set_seeing(broken, 0.0, {broken, 0.0, 0.0}));
        map.redraw({0.0, broken, 0.0});
    }
    EXPECT_EQ(occupied_cells(map.grid()), 1);
}

}  // namespace
}  // namespace flownav::mapping
