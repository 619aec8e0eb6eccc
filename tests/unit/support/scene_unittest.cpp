#include "flownav/testing/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "flownav/math/units.h"

namespace flownav::testing {
namespace {

TEST(Scene, SameSeedGivesTheSameSceneAndAnotherSeedAnother) {
    const auto centres = [](const Scene& scene) {
        std::vector<double> x;
        for (const Solid& solid : scene.world.solids) x.push_back(solid.T_world_solid.translation().x());
        return x;
    };
    EXPECT_EQ(centres(make_scene(SceneKind::SCurve, 5)), centres(make_scene(SceneKind::SCurve, 5)));
    EXPECT_NE(centres(make_scene(SceneKind::SCurve, 5)), centres(make_scene(SceneKind::SCurve, 6)));
}

TEST(Scene, NothingStandsNearerThanHalfAMetreToThePath) {
    for (const SceneKind kind :
         {SceneKind::Straight, SceneKind::SCurve, SceneKind::Turns, SceneKind::Corridor}) {
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const Scene scene = make_scene(kind, seed);
            double nearest_m = 1e9;
            for (const Pose2& pose : scene.poses) {
                for (const Solid& solid : scene.world.solids)
                    nearest_m = std::min(nearest_m, distance_m(solid, {pose.x_m, pose.y_m}));
            }
            EXPECT_GE(nearest_m, 0.499) << to_string(kind) << " seed " << seed;
        }
    }
}

TEST(Scene, HasManyObjectsAndWallsOnAllSides) {
    for (const SceneKind kind :
         {SceneKind::Straight, SceneKind::SCurve, SceneKind::Turns, SceneKind::Corridor}) {
        std::set<int> objects;
        for (const Solid& solid : make_scene(kind, 1).world.solids) objects.insert(solid.object);
        EXPECT_GE(objects.size(), 8U) << to_string(kind);
        EXPECT_TRUE(objects.count(wall_object)) << to_string(kind);
    }
    EXPECT_TRUE(make_scene(SceneKind::Free, 1).world.solids.empty());
}

TEST(Scene, SpeedAndTurnRateAreThoseOfTheDrive) {
    for (const SceneKind kind : all_scene_kinds) {
        const Scene scene = make_scene(kind, 1);
        double fastest_radps = 0.0;
        for (std::size_t i = 1; i < scene.poses.size(); ++i) {
            const EgoMotion motion = exact_motion(scene.poses[i - 1], scene.poses[i]);
            EXPECT_LT(motion.forward_m * 25.0, 0.4001);
            EXPECT_GT(motion.forward_m * 25.0, kind == SceneKind::StopAndGo ? -1e-9 : 0.3999);
            fastest_radps = std::max(fastest_radps, std::abs(motion.omega_rad) * 25.0);
        }
        EXPECT_LE(fastest_radps, 30.01 * degree_rad) << to_string(kind);
        const bool turns = kind == SceneKind::Turns || kind == SceneKind::SCurve;
        EXPECT_EQ(fastest_radps > 0.5, turns) << to_string(kind);
    }
}

TEST(Scene, StopAndGoStandsStillInBetween) {
    const Scene scene = make_scene(SceneKind::StopAndGo, 1);
    int resting = 0;
    int driving = 0;
    for (std::size_t i = 1; i < scene.poses.size(); ++i) {
        const double v_mps = exact_motion(scene.poses[i - 1], scene.poses[i]).forward_m * 25.0;
        resting += v_mps < 1e-9 ? 1 : 0;
        driving += v_mps > 0.399 ? 1 : 0;
    }
    EXPECT_GE(resting, 30);
    EXPECT_GE(driving, 40);
}

TEST(Scene, OpenShutterBlursAlongTheMotionOnly) {
    SceneOptions options;
    options.camera = standard_camera(160, 120);
    options.kind = SceneKind::Free;
    options.speed_mps = 1.5;
    options.effects.noise_sigma = 0.0;
    const Scene sharp = make_scene(options);
    options.effects.exposure_s = 0.03;
    const Scene blurred = make_scene(options);
    const auto roughness = [](const GreyImage& image) {
        double sum = 0.0;
        for (int v = 60; v < 119; ++v) {
            for (int u = 60; u < 100; ++u) sum += std::abs(image.at(u, v + 1) - image.at(u, v));
        }
        return sum;
    };
    EXPECT_LT(roughness(render_image(blurred, 5)), 0.9 * roughness(render_image(sharp, 5)));
    const auto difference = [](const GreyImage& a, const GreyImage& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::abs(a.pixels[i] - b.pixels[i]);
        return sum;
    };
    const GreyImage image = render_image(blurred, 5);
    EXPECT_LT(difference(image, render_image(sharp, 5)), difference(image, render_image(sharp, 4)));
    EXPECT_LT(difference(image, render_image(sharp, 5)), difference(image, render_image(sharp, 6)));
}

TEST(Scene, InterlacedImagesAlternateTheirParityTopFirst) {
    SceneOptions options;
    options.camera = standard_camera(768, 576);
    options.interlaced = true;
    const Scene scene = make_scene(options);
    EXPECT_DOUBLE_EQ(nominal_view(scene, 0).camera.cy_px, 143.75);
    EXPECT_DOUBLE_EQ(nominal_view(scene, 1).camera.cy_px, 143.25);
    EXPECT_DOUBLE_EQ(nominal_view(scene, 2).camera.cy_px, 143.75);
}

TEST(Scene, VibrationMovesTheTrueCameraAndLeavesTheNominalOne) {
    SceneOptions options;
    options.effects.pitch_vibration_rad = 0.002;
    options.effects.floor_sigma_m = 0.005;
    const Scene scene = make_scene(options);
    double square = 0.0;
    for (int i = 0; i < scene.images(); ++i) {
        EXPECT_DOUBLE_EQ(nominal_view(scene, i).camera.mount.pitch_rad, options.camera.mount.pitch_rad);
        square += std::pow(true_view(scene, i).camera.mount.pitch_rad - options.camera.mount.pitch_rad, 2);
    }
    EXPECT_NEAR(std::sqrt(square / scene.images()), 0.002, 0.0005);
    EXPECT_NE(true_view(scene, 0).camera.mount.height_m, options.camera.mount.height_m);
}

TEST(Scene, FieldKeepsItsPixelsAlive) {
    SceneOptions options;
    options.camera = standard_camera(64, 48);
    const Field field = make_field(make_scene(options), 3);
    EXPECT_DOUBLE_EQ(field.timestamp_s, scene_start_s + 0.12);
    EXPECT_EQ(field.image.width_px, 64);
    EXPECT_GT(field.image.at(30, 40), 20);
}

TEST(Scene, FloorsHaveNames) {
    EXPECT_EQ(floor_surface("stoneware"), Surface::Stoneware);
    EXPECT_EQ(floor_surface("marbled"), Surface::Marbled);
    EXPECT_EQ(floor_surface("tiles"), Surface::Tiles);
    EXPECT_EQ(floor_surface("grass"), std::nullopt);
}

TEST(Scene, NumbersOutOfRangeAreRefused) {
    SceneOptions options;
    options.images = 1;
    EXPECT_THROW(make_scene(options), std::invalid_argument);
    options = {};
    options.rate_hz = 0.0;
    EXPECT_THROW(make_scene(options), std::invalid_argument);
    options = {};
    options.camera.width_px = 0;
    EXPECT_THROW(make_scene(options), std::invalid_argument);
}

TEST(Scene, KindsAreFoundByTheirNames) {
    for (const SceneKind kind : all_scene_kinds) EXPECT_EQ(scene_kind(to_string(kind)), kind);
    EXPECT_EQ(scene_kind("maze"), std::nullopt);
}

}  // namespace
}  // namespace flownav::testing
