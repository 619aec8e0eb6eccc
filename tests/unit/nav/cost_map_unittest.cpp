#include "planner/cost_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using mrpt::maps::COccupancyGridMap2D;

constexpr float free_cell = 0.9F;
constexpr float unknown_cell = 0.5F;
constexpr float occupied_cell = 0.1F;
constexpr double cell_m = 0.05;
constexpr int columns = 60;
constexpr int rows = 40;
// Half the width of the default robot plus the margin.
constexpr double closed_m = 0.2 + 0.07;

/// Free ground, 3 m long and 2 m wide, with its corner at (-1, -0.5).
COccupancyGridMap2D free_map() {
    COccupancyGridMap2D map(-1.0F, 2.0F, -0.5F, 1.5F, static_cast<float>(cell_m));
    map.fill(free_cell);
    return map;
}

/// The cells of free_map() extended by `border` on every side.
GridArea area_with(int border) {
    GridArea area;
    area.cell_m = cell_m;
    area.origin_m = Vector2d(-1.0, -0.5) - Vector2d::Constant(border * cell_m);
    area.columns = columns + 2 * border;
    area.rows = rows + 2 * border;
    return area;
}

CostMap costs_of(const COccupancyGridMap2D& map, const PlanParams& params = {}, int border = 0) {
    return {map, area_with(border), RobotModel(), params};
}

template <typename Visit>
void for_every_cell(Visit visit) {
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) visit(Vector2i(column, row));
}

TEST(CostMap, AMetreOverFreeGroundCostsAMetre) {
    const CostMap costs = costs_of(free_map());
    for_every_cell([&](const Vector2i& cell) { EXPECT_EQ(costs.cost(cell), 1.0F); });
}

TEST(CostMap, AnOccupiedCellIsAnObstacleWhereItIsAndNowhereElse) {
    const std::vector<Vector2i> places = {{45, 10},         {10, 35},      {0, 0},
                                          {columns - 1, 0}, {0, rows - 1}, {columns - 1, rows - 1}};
    for (const Vector2i& place : places) {
        COccupancyGridMap2D map = free_map();
        map.setCell(place.x(), place.y(), occupied_cell);
        const CostMap costs = costs_of(map);
        for_every_cell([&](const Vector2i& cell) {
            EXPECT_EQ(costs.is_obstacle(cell), cell == place)
                << cell.transpose() << ", " << place.transpose();
        });
    }
}

TEST(CostMap, XGoesToTheRightAndYUp) {
    COccupancyGridMap2D map = free_map();
    map.setCell(map.x2idx(1.62), map.y2idx(-0.22), occupied_cell);
    const CostMap costs = costs_of(map);
    EXPECT_TRUE(costs.is_obstacle(costs.area().cell_of({1.62, -0.22})));
    EXPECT_FALSE(costs.is_closed(costs.area().cell_of({-0.22, 1.22})));
    EXPECT_FALSE(costs.is_closed(costs.area().cell_of({-0.62, -0.22})));
    EXPECT_FALSE(costs.is_closed(costs.area().cell_of({1.62, 1.22})));
    EXPECT_EQ(costs.area().cell_of({1.62, -0.22}), Vector2i(52, 5));
    EXPECT_NEAR(costs.area().middle_of({52, 5}).x(), 1.625, 1e-12);
    EXPECT_NEAR(costs.area().middle_of({52, 5}).y(), -0.225, 1e-12);
}

TEST(CostMap, NoRobotFitsNearerThanHalfItsWidthAndTheMargin) {
    COccupancyGridMap2D map = free_map();
    const Vector2i post(20, 18);
    map.setCell(post.x(), post.y(), occupied_cell);
    const CostMap costs = costs_of(map);
    for_every_cell([&](const Vector2i& cell) {
        const double distance_m = (cell - post).cast<double>().norm() * cell_m;
        // The distances of the raster have an error of 3 %.
        if (std::abs(distance_m - closed_m) < 0.01) return;
        EXPECT_EQ(costs.is_closed(cell), distance_m < closed_m) << distance_m << " m away";
    });
}

TEST(CostMap, ComfortFallsOffWithTheDistanceInEveryDirection) {
    COccupancyGridMap2D map = free_map();
    const Vector2i post(30, 20);
    map.setCell(post.x(), post.y(), occupied_cell);
    const PlanParams params;
    const CostMap costs = costs_of(map, params);
    for (const Vector2i& step : {Vector2i(1, 0), Vector2i(-1, 0), Vector2i(0, 1), Vector2i(0, -1)}) {
        double before = 1.0 + params.comfort_cost;
        for (int k = 6; k * cell_m < closed_m + params.comfort_m; ++k) {  // 0.30 m to 0.55 m
            const double cost = costs.cost(post + k * step);
            EXPECT_LT(cost, before);
            EXPECT_GT(cost, 1.0);
            if (k == 6) {
                EXPECT_GT(cost, 1.0 + 0.7 * params.comfort_cost) << "nearly all of it right at the margin";
            }
            before = cost;
        }
        EXPECT_EQ(costs.cost(post + 12 * step), 1.0F);  // 0.60 m
    }
}

TEST(CostMap, UnknownGroundIsDearerThanFreeAndEvidenceMakesItCheaper) {
    COccupancyGridMap2D map = free_map();
    map.setCell(10, 10, unknown_cell);
    map.setCell(20, 10, 0.6F);
    map.setCell(30, 10, 0.75F);
    const PlanParams params;
    const CostMap costs = costs_of(map, params);
    EXPECT_NEAR(costs.cost({10, 10}), 1.0 + params.unknown_cost, 0.03);  // MRPT keeps log-odds in 8 bits
    EXPECT_LT(costs.cost({20, 10}), costs.cost({10, 10}));
    EXPECT_GT(costs.cost({20, 10}), costs.cost({30, 10}));
    EXPECT_EQ(costs.cost({30, 10}), 1.0F);
}

TEST(CostMap, OnlyCellsLessLikelyFreeThanTheLimitAreObstacles) {
    COccupancyGridMap2D map = free_map();
    map.setCell(10, 10, 0.42F);
    map.setCell(40, 10, 0.48F);
    const CostMap costs = costs_of(map);
    EXPECT_TRUE(costs.is_obstacle({10, 10}));
    EXPECT_FALSE(costs.is_closed({40, 10}));
}

TEST(CostMap, PlacesToAvoidAreDearerAndAgainForEach) {
    PlanParams params;
    const Vector2d place_m(0.4, 0.3);
    params.avoid_m = {place_m};
    const CostMap once = costs_of(free_map(), params);
    params.avoid_m = {place_m, place_m};
    const CostMap twice = costs_of(free_map(), params);
    for_every_cell([&](const Vector2i& cell) {
        const double distance_m = (once.area().middle_of(cell) - place_m).norm();
        if (std::abs(distance_m - params.avoid_radius_m) < 1e-6) return;
        const double extra = distance_m < params.avoid_radius_m ? params.avoid_cost : 0.0;
        EXPECT_NEAR(once.cost(cell), 1.0 + extra, 1e-4) << distance_m << " m away";
        EXPECT_NEAR(twice.cost(cell), 1.0 + 2 * extra, 1e-4) << distance_m << " m away";
    });
}

TEST(CostMap, AvoidedPlacesNeverCloseAWayNorOpenOne) {
    COccupancyGridMap2D map = free_map();
    map.setCell(20, 20, occupied_cell);
    const CostMap plain = costs_of(map);
    PlanParams params;
    params.avoid_m.assign(30, plain.area().middle_of({20, 20}));
    params.avoid_m.emplace_back(-1.1, -0.6);  // outside the area
    const CostMap avoided = costs_of(map, params);
    for_every_cell([&](const Vector2i& cell) {
        EXPECT_EQ(avoided.is_closed(cell), plain.is_closed(cell));
        EXPECT_EQ(avoided.is_obstacle(cell), plain.is_obstacle(cell));
    });
    EXPECT_GT(avoided.cost({0, 0}), 8.0F) << "a place beside the area is avoided inside it";
}

TEST(CostMap, GroundRightOfTheMapAndAboveItIsUnknown) {
    const PlanParams params;
    const CostMap costs = costs_of(free_map(), params, 2);
    const double unknown = 1.0 + params.unknown_cost;
    for (int i = 0; i < columns; ++i) EXPECT_NEAR(costs.cost({i, rows + 2}), unknown, 0.03) << i;
    for (int i = 0; i < rows; ++i) EXPECT_NEAR(costs.cost({columns + 2, i}), unknown, 0.03) << i;
    EXPECT_EQ(costs.cost({columns + 1, rows + 1}), 1.0F) << "the last cell of the map";
}

TEST(CostMap, GroundLeftOfTheMapAndBelowItIsUnknown) {
    const PlanParams params;
    const CostMap costs = costs_of(free_map(), params, 2);
    const double unknown = 1.0 + params.unknown_cost;
    for (int beside : {0, 1}) {
        for (int i = 0; i < columns + 4; ++i) EXPECT_NEAR(costs.cost({i, beside}), unknown, 0.03) << i;
        for (int i = 0; i < rows + 4; ++i) EXPECT_NEAR(costs.cost({beside, i}), unknown, 0.03) << i;
    }
    EXPECT_EQ(costs.cost({2, 2}), 1.0F) << "the first cell of the map";
}

TEST(CostMap, AnObstacleAtTheBorderOfTheMapIsNoWiderThanItsCell) {
    const std::vector<Vector2i> places = {{0, 20}, {columns - 1, 20}, {30, 0}, {30, rows - 1}};
    for (const Vector2i& place : places) {
        COccupancyGridMap2D map = free_map();
        map.setCell(place.x(), place.y(), occupied_cell);
        const CostMap costs = costs_of(map, {}, 1);
        int obstacles = 0;
        for (int row = 0; row < rows + 2; ++row) {
            for (int column = 0; column < columns + 2; ++column)
                obstacles += costs.is_obstacle({column, row});
        }
        EXPECT_EQ(obstacles, 1) << place.transpose();
    }
}

TEST(AreaAround, HoldsTheMapAndBothPointsWithAMargin) {
    PlanParams params;
    params.area_margin_m = 1.0;
    const GridArea area = area_around(free_map(), {0.0, 0.0}, {5.0, -3.0}, params);
    for (const Vector2d& p : {Vector2d(-0.99, -0.49), Vector2d(1.99, 1.49), Vector2d(5.98, -3.98)})
        EXPECT_TRUE(area.contains(area.cell_of(p))) << p.transpose();
    const Vector2d high_m = area.origin_m + area.cell_m * Vector2d(area.columns, area.rows);
    EXPECT_NEAR(area.origin_m.x(), -1.0, 2 * cell_m);
    EXPECT_NEAR(area.origin_m.y(), -4.0, 2 * cell_m);
    EXPECT_NEAR(high_m.x(), 6.0, 2 * cell_m);
    EXPECT_NEAR(high_m.y(), 1.5, 2 * cell_m);
}

TEST(AreaAround, IsCutToItsGreatestEdgeAboutTheRobot) {
    PlanParams params;
    params.area_max_m = 4.0;
    const GridArea area = area_around(free_map(), {10.0, 0.0}, {100.0, 0.0}, params);
    EXPECT_NEAR(area.origin_m.x(), 8.0, 2 * cell_m);
    EXPECT_NEAR(area.origin_m.y(), -2.0, 2 * cell_m);
    EXPECT_NEAR(area.columns * area.cell_m, 4.0, 3 * cell_m);
    EXPECT_NEAR(area.rows * area.cell_m, 4.0, 3 * cell_m);
}

}  // namespace
}  // namespace flownav::nav
