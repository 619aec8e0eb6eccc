#include "flownav/math/rolling_grid.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

namespace flownav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

constexpr int power_of_two = 8;
constexpr int other_side = 6;

RollingGrid<int> grid_of(int side) {
    return RollingGrid<int>({Vector2d::Zero(), 0.1}, side);
}

TEST(RollingGrid, HoldsNoCellAtFirst) {
    for (const int side : {power_of_two, other_side}) {
        const RollingGrid<int> grid = grid_of(side);
        for (int y = -side; y <= side; ++y)
            for (int x = -side; x <= side; ++x) EXPECT_EQ(grid.find({x, y}), nullptr) << x << ", " << y;
        int visited = 0;
        grid.for_each([&](const Vector2i&, int) { ++visited; });
        EXPECT_EQ(visited, 0);
    }
}

TEST(RollingGrid, EveryCellOfAWindowHasItsOwnPlaceOnBothSidesOfBothAxes) {
    for (const int side : {power_of_two, other_side}) {
        for (const Vector2i& low :
             {Vector2i(0, 0), Vector2i(-3, -5), Vector2i(-100, 70), Vector2i(33, -91)}) {
            RollingGrid<int> grid = grid_of(side);
            int written = 0;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) grid.claim(low + Vector2i(x, y)) = ++written;
            int expected = 0;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const int* const value = grid.find(low + Vector2i(x, y));
                    ASSERT_NE(value, nullptr) << x << ", " << y;
                    EXPECT_EQ(*value, ++expected);
                }
            }
        }
    }
}

TEST(RollingGrid, CellsAWindowApartShareAPlaceAndTheNewerHoldsIt) {
    for (const int side : {power_of_two, other_side}) {
        for (const Vector2i& apart : {Vector2i(side, 0), Vector2i(-side, 0), Vector2i(0, side),
                                      Vector2i(0, -side), Vector2i(-3 * side, 2 * side)}) {
            for (const Vector2i& cell : {Vector2i(2, 1), Vector2i(-1, -4), Vector2i(0, 0)}) {
                RollingGrid<int> grid = grid_of(side);
                grid.claim(cell) = 5;
                EXPECT_EQ(grid.find(cell + apart), nullptr);
                grid.claim(cell + apart) = 7;
                EXPECT_EQ(grid.find(cell), nullptr);
                ASSERT_NE(grid.find(cell + apart), nullptr);
                EXPECT_EQ(*grid.find(cell + apart), 7);
            }
        }
    }
}

TEST(RollingGrid, ClaimingKeepsTheValueOfAHeldCellAndReplacesTheValueOfAnother) {
    RollingGrid<int> grid = grid_of(power_of_two);
    EXPECT_EQ(grid.claim({1, -1}), 0);
    grid.claim({1, -1}) = 4;
    EXPECT_EQ(grid.claim({1, -1}, 9), 4);
    EXPECT_EQ(grid.claim({1 + power_of_two, -1}, 9), 9);
}

TEST(RollingGrid, VisitsEveryHeldCellOnceAndNoneAfterClear) {
    RollingGrid<int> grid = grid_of(other_side);
    grid.claim({0, 0}) = 1;
    grid.claim({-2, 3}) = 2;
    grid.claim({4, -1}) = 3;
    std::map<std::pair<int, int>, int> visited;
    const auto visit = [&](const Vector2i& cell, int value) { visited[{cell.x(), cell.y()}] += value; };
    grid.for_each(visit);
    EXPECT_EQ(visited, (std::map<std::pair<int, int>, int>{{{0, 0}, 1}, {{-2, 3}, 2}, {{4, -1}, 3}}));
    visited.clear();
    grid.clear();
    grid.for_each(visit);
    EXPECT_TRUE(visited.empty());
    EXPECT_EQ(grid.find({0, 0}), nullptr);
}

TEST(RollingGrid, TheCellOfAPointIsThatOfItsFrame) {
    const RollingGrid<int> grid = grid_of(power_of_two);
    EXPECT_EQ(grid.frame().cell_of({0.05, -0.05}), Vector2i(0, -1));
    EXPECT_EQ(grid.frame().cell_of({-0.05, 0.05}), Vector2i(-1, 0));
}

}  // namespace
}  // namespace flownav
