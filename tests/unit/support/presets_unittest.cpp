#include "flownav/testing/presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace flownav::testing {
namespace {

Scene scene_of(const std::string& name, std::uint64_t seed = 1) {
    return make_scene(preset(name, seed).value());
}

TEST(Presets, AllOfThemMakeScenesAndHaveNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const Preset& p : all_presets()) {
        EXPECT_TRUE(names.insert(p.name).second) << p.name;
        EXPECT_GE(scene_of(p.name).images(), 200) << p.name;
    }
    EXPECT_GE(names.size(), 20U);
    EXPECT_EQ(preset("maze", 1), std::nullopt);
}

TEST(Presets, SeedChangesTheScene) {
    EXPECT_NE(scene_of("carpet", 1).world.solids[20].T_world_solid.translation(),
              scene_of("carpet", 2).world.solids[20].T_world_solid.translation());
}

TEST(Presets, EveryKindOfThingStandsAlongTheWay) {
    std::set<ThingKind> kinds;
    for (const std::uint64_t seed : {1U, 2U}) {
        for (const Solid& solid : scene_of("carpet", seed).world.solids) kinds.insert(solid.kind);
    }
    for (const ThingKind kind : {ThingKind::Wall, ThingKind::Box, ThingKind::LowBox, ThingKind::Pole,
                                 ThingKind::Drum, ThingKind::Chair, ThingKind::Rail})
        EXPECT_TRUE(kinds.count(kind)) << to_string(kind);
}

TEST(Presets, NothingStandsInTheWayOfAnyOfThem) {
    for (const Preset& p : all_presets()) {
        const Scene scene = scene_of(p.name);
        const double least_m = scene.options.near_boxes ? 0.2 : 0.499;
        for (const Solid& thing : scene.world.solids) {
            if (thing.kind == ThingKind::Mover) continue;
            double nearest_m = 9.0;
            for (const Pose2& pose : scene.poses)
                nearest_m = std::min(nearest_m, distance_m(thing, {pose.x_m, pose.y_m}));
            EXPECT_GE(nearest_m, least_m) << p.name << ' ' << to_string(thing.kind);
        }
    }
}

/// Share of the image from row `from_row` down that objects of a kind cover.
double covered(const Scene& scene, int image, ThingKind kind, double from_row) {
    const View view = true_view(scene, image);
    int hits = 0;
    int all = 0;
    for (int v = static_cast<int>(from_row); v < view.camera.height_px; v += 16) {
        for (int u = 8; u < view.camera.width_px; u += 16) {
            const auto sight = look(scene.world, view, {u, v});
            hits += sight && sight->solid >= 0 &&
                    scene.world.solids[static_cast<std::size_t>(sight->solid)].kind == kind;
            ++all;
        }
    }
    return static_cast<double>(hits) / all;
}

TEST(Presets, MoversCoverHalfOfTheViewAboveTheGroundWindowForSeconds) {
    for (const std::string name : {"mover25", "mover45"}) {
        const Scene scene = scene_of(name);
        int images = 0;
        for (int i = 0; i < scene.images(); i += 5)
            images += covered(scene, i, ThingKind::Mover, 0.0) > 0.3 ? 5 : 0;
        EXPECT_GE(images, 50) << name;
        EXPECT_LT(covered(scene, 0, ThingKind::Mover, 0.0), 0.25) << name;
    }
}

TEST(Presets, NearObstaclesStandInsideTheGroundWindowMostOfTheTime) {
    const Scene scene = scene_of("near-obstacle");
    int images = 0;
    for (int i = 0; i < scene.images(); i += 10) {
        const double inside =
            covered(scene, i, ThingKind::LowBox, 320.0) + covered(scene, i, ThingKind::Box, 320.0);
        images += inside > 0.02 ? 10 : 0;
    }
    EXPECT_GE(images, 100);
}

TEST(Presets, WideLensIsNinetyDegreesWideAndInvertibleInItsCorners) {
    const CameraModel camera = scene_of("wide").options.camera;
    const RayMapper mapper(camera);
    EXPECT_NEAR(std::atan(mapper.ray({camera.width_px - 0.5, camera.cy_px}).x()), M_PI / 4, 0.01);
    const Eigen::Vector2d corner(0.0, 0.0);
    EXPECT_LT((mapper.pixel(mapper.ray(corner)) - corner).norm(), 0.01);
}

TEST(Presets, LoopComesBackToItsStartAroundTheRailing) {
    SceneOptions options;
    options.kind = SceneKind::Loop;
    options.images = 1020;
    const Scene scene = make_scene(options);
    EXPECT_NEAR(scene.poses.back().x_m, 0.0, 0.1);
    EXPECT_NEAR(scene.poses.back().y_m, 0.0, 0.02);
    EXPECT_NEAR(std::abs(scene.poses.back().yaw_rad), 0.0, 1e-3);
    EXPECT_TRUE(std::any_of(scene.world.solids.begin(), scene.world.solids.end(),
                            [](const Solid& solid) { return solid.kind == ThingKind::Rail; }));
}

}  // namespace
}  // namespace flownav::testing
