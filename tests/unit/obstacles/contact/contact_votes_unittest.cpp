#include "flownav/obstacles/contact_votes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "level_world.h"

namespace flownav::obstacles {
namespace {

using testing::LevelView;
using testing::LevelWorld;

constexpr double travel_m = 0.16;
constexpr double noise = 1.0;
constexpr double contact_m = 1.2;

/// How much better the strips of a view move as floor than as a surface at contact_m. The camera does not
/// look at the columns from `blind_column` on.
std::optional<double> preference_at(double right, const LevelWorld& world, int blind_column = 320) {
    LevelView later;
    later.T_world_camera.x_m = travel_m;
    LevelImage reference = draw(world, {});
    LevelImage newer = draw(world, later);
    for (int v = 0; v < newer.height; ++v) {
        for (int u = blind_column; u < newer.width; ++u)
            reference.row(v)[u] = newer.row(v)[u] = std::numeric_limits<float>::quiet_NaN();
    }
    PairMotion motion;
    motion.forward_m = travel_m;
    const PairWarp warp = pair_warp(reference.camera, newer.camera, motion);
    const StripGrid grid = strip_grid(newer);
    FloorComparison comparison;
    compare_with_floor(reference, newer, warp, noise, {0, grid.strips}, comparison);
    const int strip = static_cast<int>(std::floor(right / strip_tangent)) - grid.first;
    return floor_preference(reference, newer, warp, comparison, noise, strip, contact_m);
}

LevelWorld grainy() {
    LevelWorld world;
    world.contrast = 0.0;
    world.grain = 6.0;
    return world;
}

TEST(FloorPreference, TexturedFloorMovesAsFloorOnEitherSide) {
    for (const double right : {-0.5, 0.5}) {
        const auto preference = preference_at(right, grainy());
        ASSERT_TRUE(preference);
        EXPECT_GT(*preference, 0.4) << right;
    }
}

TEST(FloorPreference, ASurfaceOfOneColourTellsNothing) {
    LevelWorld world = grainy();
    world.screens.push_back({contact_m + travel_m, 0.0, 4.0, 1.5, 60.0});
    const auto preference = preference_at(0.2, world);
    ASSERT_TRUE(preference);
    EXPECT_LT(*preference, 0.4);
}

TEST(FloorPreference, PixelsBesideABorderOfTheViewAreLeftOut) {
    const LevelCamera camera = testing::level_camera();
    const int border = static_cast<int>(camera.column_of(0.58, camera.row_of(camera.height_m / contact_m)));
    const auto preference = preference_at(0.5, grainy(), border);
    ASSERT_TRUE(preference);
    EXPECT_TRUE(std::isfinite(*preference));
    EXPECT_GT(*preference, 0.4);
}

}  // namespace
}  // namespace flownav::obstacles
