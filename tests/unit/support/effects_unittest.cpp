#include "flownav/testing/effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "flownav/math/units.h"
#include "flownav/sim/ground.h"
#include "flownav/testing/scene.h"

namespace flownav::testing {
namespace {

constexpr int images = 400;

std::vector<double> gains_of(const CameraEffects& effects) {
    std::vector<double> gains;
    gains.reserve(images);
    for (int i = 0; i < images; ++i) gains.push_back(effects_of_image(effects, i).gain);
    return gains;
}

TEST(Exposure, StepsByItsShareAndIsHeldForHalfASecondToASecond) {
    CameraEffects effects;
    effects.exposure_step = 0.1;
    const std::vector<double> gains = gains_of(effects);
    std::vector<int> steps;
    for (int i = 1; i < images; ++i) {
        const double ratio = gains[i] / gains[i - 1];
        if (ratio == 1.0) continue;
        EXPECT_NEAR(std::max(ratio, 1.0 / ratio), 1.1, 1e-9);
        steps.push_back(i);
    }
    ASSERT_GE(steps.size(), 15U);
    for (std::size_t k = 1; k < steps.size(); ++k) {
        EXPECT_GE(steps[k] - steps[k - 1], 12);
        EXPECT_LE(steps[k] - steps[k - 1], 24);
    }
    EXPECT_GE(*std::min_element(gains.begin(), gains.end()), 1.0 / 1.22);
    EXPECT_LE(*std::max_element(gains.begin(), gains.end()), 1.22);
}

TEST(Flicker, IsASineFromImageToImage) {
    CameraEffects effects;
    effects.flicker = 0.05;
    const std::vector<double> gains = gains_of(effects);
    EXPECT_NEAR(*std::max_element(gains.begin(), gains.end()), 1.05, 0.001);
    EXPECT_NEAR(*std::min_element(gains.begin(), gains.end()), 0.95, 0.001);
    EXPECT_NEAR(gains[33], gains[0], 1e-9);  // after ten periods
}

TEST(Effects, AreNoneUnlessAskedFor) {
    for (const double gain : gains_of({})) EXPECT_EQ(gain, 1.0);
}

Scene on_waves(double highest_m) {
    SceneOptions options;
    options.kind = SceneKind::Straight;
    options.floor_waves_m = highest_m;
    return make_scene(options);
}

TEST(UnevenFloor, StaysWithinItsHeightAndUsesMostOfIt) {
    const World world = on_waves(0.012).world;
    double lowest_m = 0.0;
    double highest_m = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double height_m = ground_height_m(world, {0.037 * i, 0.0211 * i});
        lowest_m = std::min(lowest_m, height_m);
        highest_m = std::max(highest_m, height_m);
    }
    EXPECT_GE(lowest_m, -0.012);
    EXPECT_LE(highest_m, 0.012);
    EXPECT_GT(highest_m - lowest_m, 0.018);
}

TEST(UnevenFloor, LooksMeetItsSurface) {
    const Scene scene = on_waves(0.012);
    for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(320, 240), Eigen::Vector2d(50, 470),
                                         Eigen::Vector2d(600, 300), Eigen::Vector2d(320, 120)}) {
        const auto sight = look(scene.world, true_view(scene, 10), pixel);
        ASSERT_TRUE(sight);
        if (sight->solid != floor_index) continue;
        EXPECT_NEAR(sight->point_m.z(), ground_height_m(scene.world, sight->point_m.head<2>()), 1e-5);
    }
}

TEST(UnevenFloor, MakesTheRobotHeaveAndPitchALittleAndSmoothly) {
    const Scene scene = on_waves(0.012);
    const CameraMount nominal = scene.options.camera.mount;
    double square_pitch = 0.0;
    double fastest_m = 0.0;
    for (int i = 1; i < scene.images(); ++i) {
        const CameraMount mount = true_view(scene, i).camera.mount;
        EXPECT_LT(std::abs(mount.height_m - nominal.height_m), 0.0121);
        square_pitch += std::pow(mount.pitch_rad - nominal.pitch_rad, 2) / scene.images();
        const double before_m = true_view(scene, i - 1).camera.mount.height_m;
        fastest_m = std::max(fastest_m, std::abs(mount.height_m - before_m));
    }
    EXPECT_GT(deg(std::sqrt(square_pitch)), 0.03);
    EXPECT_LT(deg(std::sqrt(square_pitch)), 0.3);
    EXPECT_LT(fastest_m, 0.003);
}

}  // namespace
}  // namespace flownav::testing
