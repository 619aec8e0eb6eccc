#include <gtest/gtest.h>
#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <cmath>

#include "flownav/io/observations.h"
#include "flownav/math/units.h"

namespace flownav::io {
namespace {

using mrpt::maps::COccupancyGridMap2D;

/// 41 beams of 2 degrees. Within 4 degrees of straight ahead an obstacle at 4.05 m; from 20 degrees to the
/// left on free floor up to 2 m; all else blind.
pipeline::Step cycle() {
    pipeline::Step step;
    step.timestamp_s = 1767225600.0;
    step.status = FieldStatus::Ok;
    step.end_of_cycle = true;
    step.scan.first_bearing_rad = -40 * degree_rad;
    step.scan.step_rad = 2 * degree_rad;
    step.scan.beams.resize(41);
    for (std::size_t i = 18; i <= 22; ++i) step.scan.beams[i] = {BeamKind::Obstacle, 4.05};
    for (std::size_t i = 30; i <= 40; ++i) step.scan.beams[i] = {BeamKind::Free, 2.0};
    step.obstacles = {{{4.0, 0.1, 0.3}, 0.1, {160.0, 100.0}}, {{4.0, -0.1, 0.9}, 0.1, {150.0, 80.0}}};
    return step;
}

float at(const COccupancyGridMap2D& grid, double bearing_deg, double range_m) {
    return grid.getPos(static_cast<float>(range_m * std::cos(bearing_deg * degree_rad)),
                       static_cast<float>(range_m * std::sin(bearing_deg * degree_rad)));
}

/// Range of the farthest free cell along a bearing, up to a beam to either side.
double free_up_to_m(const COccupancyGridMap2D& grid, double bearing_deg) {
    double farthest_m = 0;
    for (int step = 0; step < 190; ++step) {
        for (const double aside_deg : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
            if (at(grid, bearing_deg + aside_deg, 0.05 * step) > 0.51) farthest_m = 0.05 * step;
        }
    }
    return farthest_m;
}

COccupancyGridMap2D grid_with(const pipeline::Step& step, bool invalid_is_free) {
    COccupancyGridMap2D grid(-10, 10, -10, 10, 0.1F);
    grid.insertionOptions.considerInvalidRangesAsFreeSpace = invalid_is_free;
    EXPECT_TRUE(grid.insertObservation(*scan_observation(step, 8.0)));
    return grid;
}

TEST(MapInsertion, AScanMarksItsObstacleAndWhatLiesBefore) {
    const auto grid = grid_with(cycle(), false);
    EXPECT_LT(at(grid, 0, 4.05), 0.45);
    EXPECT_GT(at(grid, 0, 2), 0.55);
    EXPECT_NEAR(at(grid, 0, 5), 0.5, 0.01);
}

TEST(MapInsertion, ABlindBearingLeavesTheCellsAsTheyWere) {
    const auto grid = grid_with(cycle(), false);
    for (const double bearing_deg : {-38.0, -20.0, -12.0, 12.0, 16.0}) {
        for (int cell = 5; cell < 80; ++cell) {
            ASSERT_NEAR(at(grid, bearing_deg, 0.1 * cell), 0.5, 0.01) << bearing_deg << " deg, cell " << cell;
        }
    }
}

TEST(MapInsertion, AContactIsARangeWhateverItsCauseAndUnknownIsInvalid) {
    for (const BeamCause cause : {BeamCause::Votes, BeamCause::Wall, BeamCause::Drop}) {
        pipeline::Step step = cycle();
        for (std::size_t i = 18; i <= 22; ++i)
            step.scan.beams[i] = {BeamKind::Obstacle, 4.05, cause, 3.8, 4.5};
        const auto scan = scan_observation(step, 8.0);
        EXPECT_TRUE(scan->getScanRangeValidity(20));
        EXPECT_EQ(scan->getScanRange(20), 4.05F);
        EXPECT_FALSE(scan->getScanRangeValidity(5)) << "unknown";
        const auto grid = grid_with(step, false);
        EXPECT_LT(at(grid, 0, 4.05), 0.45);
        EXPECT_GT(at(grid, 0, 2), 0.55);
        EXPECT_NEAR(at(grid, -30, 2.05), 0.5, 0.01);
    }
}

TEST(MapInsertion, WithMrptsDefaultOptionABlindBearingIsFreeFarOut) {
    // The option must be switched off, because no value of a beam prevents the insertion.
    EXPECT_TRUE(COccupancyGridMap2D::TInsertionOptions().considerInvalidRangesAsFreeSpace);
    const auto grid = grid_with(cycle(), true);
    EXPECT_NEAR(free_up_to_m(grid, -20), 7.5, 0.5) << "half of maxDistanceInsertion, 15 m";
    EXPECT_NEAR(free_up_to_m(grid, 16), 2.03, 0.3) << "half of the valid range before it, 4.05 m";
}

TEST(MapInsertion, APointsMapTakesScanAndPoints) {
    mrpt::maps::CSimplePointsMap of_scan;
    EXPECT_TRUE(of_scan.insertObservation(*scan_observation(cycle(), 8.0)));
    EXPECT_EQ(of_scan.size(), 5U);
    mrpt::maps::CSimplePointsMap of_points;
    EXPECT_TRUE(of_points.insertObservation(*points_observation(cycle())));
    ASSERT_EQ(of_points.size(), 2U);
    float x = 0;
    float y = 0;
    float z = 0;
    of_points.getPoint(1, x, y, z);
    EXPECT_NEAR(x, 4.0, 1e-6);
    EXPECT_NEAR(y, -0.1, 1e-6);
    EXPECT_NEAR(z, 0.9, 1e-6);
}

TEST(MapInsertion, ACycleThatSawNothingChangesNoMap) {
    pipeline::Step step = cycle();
    step.scan.beams.assign(41, {});
    step.obstacles.clear();
    const auto grid = grid_with(step, false);
    for (int bearing_deg = -180; bearing_deg < 180; bearing_deg += 5) {
        for (int cell = 0; cell < 90; ++cell) ASSERT_NEAR(at(grid, bearing_deg, 0.1 * cell), 0.5, 0.01);
    }
    mrpt::maps::CSimplePointsMap points;
    points.insertObservation(*scan_observation(step, 8.0));
    points.insertObservation(*points_observation(step));
    EXPECT_TRUE(points.empty());
}

}  // namespace
}  // namespace flownav::io
