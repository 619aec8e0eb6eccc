#include "flownav/testing/render.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "flownav/math/units.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/scene.h"

namespace flownav::testing {
namespace {

using Eigen::Vector2d;

double sample(const GreyImage& image, const Vector2d& at) {
    const int u = static_cast<int>(std::floor(at.x()));
    const int v = static_cast<int>(std::floor(at.y()));
    const double fx = at.x() - u;
    const double fy = at.y() - v;
    return (1 - fy) * ((1 - fx) * image.at(u, v) + fx * image.at(u + 1, v)) +
           fy * ((1 - fx) * image.at(u, v + 1) + fx * image.at(u + 1, v + 1));
}

Vector2d gradient_at(const GreyImage& image, const Vector2d& at) {
    const Vector2d right(1.0, 0.0);
    const Vector2d down(0.0, 1.0);
    return 0.5 * Vector2d(sample(image, at + right) - sample(image, at - right),
                          sample(image, at + down) - sample(image, at - down));
}

/// Agreement of two images after compensation of the exact flow.
struct Agreement {
    double rms_grey = 0.0;
    Vector2d offset_px = Vector2d::Zero();  ///< mean residual displacement (one Gauss-Newton step)
    int points = 0;
};

Agreement agreement(const World& world, const View& from, const View& to, double flow_scale = 1.0) {
    const GreyImage first = render(world, from);
    const GreyImage second = render(world, to);
    Agreement result;
    Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
    Vector2d b = Vector2d::Zero();
    for (int v = 4; v < first.height_px - 4; v += 2) {
        for (int u = 4; u < first.width_px - 4; u += 2) {
            const auto truth = exact_flow(world, from, to, Vector2d(u, v));
            if (!truth || truth->occluded || truth->sight.solid != floor_index) continue;
            const Vector2d at = Vector2d(u, v) + flow_scale * truth->flow_px;
            if (at.x() < 2 || at.y() < 2 || at.x() > first.width_px - 4 || at.y() > first.height_px - 4)
                continue;
            const double difference = sample(second, at) - first.at(u, v);
            const Vector2d gradient = 0.5 * (gradient_at(first, {u, v}) + gradient_at(second, at));
            A += gradient * gradient.transpose();
            b += gradient * difference;
            result.rms_grey += difference * difference;
            ++result.points;
        }
    }
    result.rms_grey = std::sqrt(result.rms_grey / std::max(1, result.points));
    result.offset_px = A.inverse() * b;
    return result;
}

View small_view(const Pose2& pose = {}, double time_s = 0.0) {
    return {standard_camera(320, 240), pose, time_s};
}

TEST(Render, PicturesAgreeWithTheExactFlowOfADriveThroughATurn) {
    const Scene scene = make_scene(SceneKind::SCurve, 3);
    const Pose2 first = scene.poses[30];
    const Agreement exact = agreement(scene.world, small_view(first), small_view(scene.poses[33]));
    EXPECT_GT(exact.points, 2000);
    EXPECT_LT(exact.rms_grey, 4.0);
    EXPECT_LT(exact.offset_px.norm(), 0.05);  // pixels at an object's outline mix object and background
    World floor = scene.world;
    floor.solids.clear();
    EXPECT_LT(agreement(floor, small_view(first), small_view(scene.poses[33])).offset_px.norm(), 0.01);
    const Agreement wrong = agreement(scene.world, small_view(first), small_view(scene.poses[33]), 1.1);
    EXPECT_GT(wrong.rms_grey, 1.8 * exact.rms_grey);
}

TEST(Render, PicturesAgreeWithTheExactFlowOfPitchRollAndHeight) {
    View to = small_view({0.01, 0.0, 0.0});
    to.camera.mount.pitch_rad += 0.3 * degree_rad;
    to.camera.mount.roll_rad += 0.4 * degree_rad;
    to.camera.mount.height_m += 0.01;
    const Agreement exact = agreement(World{}, small_view(), to);
    EXPECT_LT(exact.rms_grey, 4.0);
    EXPECT_LT(exact.offset_px.norm(), 0.01);
}

TEST(Render, PicturesOfADistortedCameraAgreeWithTheExactFlow) {
    View from = small_view();
    from.camera.distortion = {-0.2, 0.05, 0.001, 0.001, 0.0};
    View to = from;
    to.T_world_robot = {0.03, 0.0, 0.02};
    EXPECT_LT(agreement(World{}, from, to).offset_px.norm(), 0.01);
}

TEST(Render, PicturesOfAnUnevenFloorAgreeWithTheExactFlow) {
    World uneven;
    uneven.waves = {0.012, 3};
    const View to = small_view({0.03, 0.0, 0.02});
    EXPECT_LT(agreement(uneven, small_view(), to).offset_px.norm(), 0.01);
    EXPECT_LT(agreement(uneven, small_view(), to).rms_grey, 4.0);
}

TEST(Render, FieldsOfOtherParityAgreeWithTheExactFlow) {
    const CameraModel frame = standard_camera(384, 288);
    const View top{field_camera(frame, Parity::Top), {}, 0.0};
    const View bottom{field_camera(frame, Parity::Bottom), {0.016, 0.0, 0.01}, 0.0};
    EXPECT_LT(agreement(World{}, top, bottom).offset_px.norm(), 0.015);
}

TEST(Render, PixelIsTheMeanOfTheFinerPixelsItCovers) {
    const Scene scene = make_scene(SceneKind::Straight, 4);
    CameraModel fine = standard_camera(320, 240);
    fine.width_px *= 4;
    fine.height_px *= 4;
    fine.fx_px *= 4;
    fine.fy_px *= 4;
    fine.cx_px = 4 * fine.cx_px + 1.5;
    fine.cy_px = 4 * fine.cy_px + 1.5;
    const GreyImage coarse_image = render(scene.world, small_view());
    const GreyImage fine_image = render(scene.world, {fine, {}, 0.0});
    double square = 0.0;
    for (int v = 0; v < 240; ++v) {
        for (int u = 0; u < 320; ++u) {
            double mean = 0.0;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i) mean += fine_image.at(4 * u + i, 4 * v + j) / 16.0;
            square += std::pow(mean - coarse_image.at(u, v), 2);
        }
    }
    EXPECT_LT(std::sqrt(square / (320 * 240)), 3.0);
}

TEST(Render, SameSeedGivesTheSameBytesWithAnyNumberOfThreads) {
    const Scene scene = make_scene(SceneKind::SCurve, 3);
    const ImageEffects effects = effects_of_image(scene.options.effects, 7);
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const GreyImage one = render(scene.world, small_view(), effects);
    omp_set_num_threads(3);
    const GreyImage three = render(scene.world, small_view(), effects);
    omp_set_num_threads(before);
    EXPECT_EQ(one.pixels, three.pixels);
}

TEST(Render, NoiseHasTheWantedStrengthAndDiffersFromImageToImage) {
    World plain;
    plain.floor.surface = Surface::Plain;
    ImageEffects effects;
    effects.noise_sigma = 3.0;
    const GreyImage clean = render(plain, small_view());
    const GreyImage noisy = render(plain, small_view(), effects);
    effects.noise_seed = 1;
    double square = 0.0;
    for (std::size_t i = 0; i < clean.pixels.size(); ++i)
        square += std::pow(static_cast<double>(noisy.pixels[i]) - clean.pixels[i], 2);
    EXPECT_NEAR(std::sqrt(square / static_cast<double>(clean.pixels.size())), 3.0, 0.1);
    EXPECT_NE(noisy.pixels, render(plain, small_view(), effects).pixels);
}

TEST(Render, ExposureAndVignettingChangeTheGreys) {
    World plain;
    plain.floor.surface = Surface::Plain;
    const int clean = render(plain, small_view()).at(160, 120);
    ImageEffects effects;
    effects.gain = 1.1;
    effects.offset = 5.0;
    effects.vignetting = 0.4;
    const GreyImage image = render(plain, small_view(), effects);
    EXPECT_NEAR(image.at(160, 120), 1.1 * clean + 5.0, 1.0);
    EXPECT_NEAR(image.at(0, 239), 1.1 * clean * 0.6 + 5.0, 2.0);
}

TEST(Render, ObjectsCoverThePixelsThatTheTruthNames) {
    World world;
    world.floor = {Surface::Plain, 110.0, 0};
    Upright pole;
    pole.shape = UprightShape::Cylinder;
    pole.centre_m = {2.0, 0.2};
    pole.half_x_m = 0.05;
    world.solids = {solid_of(pole, {Surface::Plain, 33.0, 0})};
    const View view = small_view();
    const GreyImage image = render(world, view);
    const Vector2d on_pole = *project(view, {1.95, 0.2, 0.5});
    const int pole_grey = image.at(static_cast<int>(on_pole.x()), static_cast<int>(on_pole.y()));
    const int threshold = (pole_grey + image.at(300, 200)) / 2;
    const auto shows_pole = [&](double u, double v) { return look(world, view, {u, v})->solid == 0; };
    int disagreeing = 0;
    for (int v = 100; v < image.height_px; ++v) {
        for (int u = 0; u < image.width_px; ++u) {
            const bool pole_here = shows_pole(u, v);
            const bool outline = shows_pole(u - 0.2, v) != pole_here || shows_pole(u + 0.2, v) != pole_here ||
                                 shows_pole(u, v - 0.2) != pole_here || shows_pole(u, v + 0.2) != pole_here;
            if (!outline && (image.at(u, v) < threshold) != pole_here) ++disagreeing;
        }
    }
    EXPECT_EQ(disagreeing, 0);
}

}  // namespace
}  // namespace flownav::testing
