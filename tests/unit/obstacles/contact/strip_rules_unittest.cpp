#include "flownav/obstacles/strip_rules.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "level_world.h"

namespace flownav::obstacles {
namespace {

/// Floor without edges that prefers to be floor by `preference(strip, forward_m)` a pixel; marks what of it
/// is in view.
template <class Preference>
std::vector<StripEvidence> floor_of(const Preference& preference) {
    LevelImage image;
    image.width = 320;
    image.height = 240;
    image.camera = testing::level_camera();
    const StripGrid grid = strip_grid(image);
    std::vector<FloorCell> cells(grid.size());
    for (int cell = grid.top_row / cell_rows + 1; cell < grid.cells; ++cell) {
        for (int s = 0; s < grid.strips; ++s) {
            const float p = preference(s - grid.strips / 2, cell_floor_m(image.camera, cell));
            FloorCell& c = cells[grid.index(cell, s)];
            c.pixels = c.compared = 24;
            c.floor = p > 0.3F ? 6 : 0;
            c.preference = 24.0F * p;
        }
    }
    FloorMap map;
    std::vector<StripEvidence> strips(static_cast<std::size_t>(grid.strips));
    find_floor_ends(image, cells, map, strips);
    return strips;
}

int seen(const std::vector<StripEvidence>& strips) {
    const auto is_seen = [](const StripEvidence& strip) { return strip.is_seen; };
    return static_cast<int>(std::count_if(strips.begin(), strips.end(), is_seen));
}

TEST(FloorEnds, WhereTextureEndsAlongALineItIsInViewWithoutAnyEdge) {
    const auto strips = floor_of([](int, double forward_m) { return forward_m < 0.9 ? 1.0F : 0.02F; });
    EXPECT_GT(seen(strips), static_cast<int>(strips.size()) * 3 / 4);
    EXPECT_NEAR(strips[strips.size() / 2].floor_end_m, 0.9, 0.08);
}

TEST(FloorEnds, TextureThatFadesWithTheDistanceHasNoEndInView) {
    const auto strips =
        floor_of([](int, double forward_m) { return static_cast<float>(std::max(0.0, 1.6 - forward_m)); });
    EXPECT_EQ(seen(strips), 0);
}

TEST(FloorEnds, APatchWithoutTextureInOneStripIsNoLine) {
    const auto strips =
        floor_of([](int strip, double forward_m) { return strip == 0 && forward_m > 0.9 ? 0.0F : 1.0F; });
    EXPECT_EQ(seen(strips), 0);
}

TEST(FloorEnds, FarAwayTheEndOfTextureSaysNothing) {
    EXPECT_EQ(seen(floor_of([](int, double forward_m) { return forward_m < 1.8 ? 1.0F : 0.0F; })), 0);
}

}  // namespace
}  // namespace flownav::obstacles
