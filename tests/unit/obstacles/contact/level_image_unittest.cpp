#include "flownav/obstacles/level_image.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"

namespace flownav::obstacles {
namespace {

CameraModel camera() {
    CameraModel c;
    c.width_px = 320;
    c.height_px = 240;
    c.fx_px = c.fy_px = 160.0;
    c.cx_px = 159.5;
    c.cy_px = 119.5;
    c.mount.height_m = 0.6;
    c.mount.pitch_rad = 15.0 * degree_rad;
    return c;
}

/// Dark image with a bright spot of 6x6 pixels about a place.
std::vector<std::uint8_t> spot(const Eigen::Vector2d& at_px) {
    std::vector<std::uint8_t> pixels(320 * 240, 20);
    for (int v = static_cast<int>(at_px.y()) - 2; v <= static_cast<int>(at_px.y()) + 3; ++v)
        for (int u = static_cast<int>(at_px.x()) - 2; u <= static_cast<int>(at_px.x()) + 3; ++u)
            pixels[static_cast<std::size_t>(v * 320 + u)] = 220;
    return pixels;
}

/// Centre of brightness of a level image, on its normalised plane.
Eigen::Vector2d centre(const LevelImage& image) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0.0;
    for (int v = 0; v < image.height; ++v) {
        for (int u = 0; u < image.width; ++u) {
            const double w = image.row(v)[u] - 20.0;
            if (std::isnan(w)) continue;
            sum += w * Eigen::Vector2d((u - image.camera.cx_px) / image.camera.fx_px,
                                       (v - image.camera.cy_px) / image.camera.fy_px);
            weight += w;
        }
    }
    return sum / weight;
}

LevelImage level_image(const std::vector<std::uint8_t>& pixels, const CameraModel& c,
                       double vignetting = 0.0) {
    const RayMapper mapper(c);
    LevelImage image;
    LevelMapping(mapper).apply({pixels.data(), 320, 240, 320}, mapper, image);
    take_out_vignetting(image, vignetting);
    return image;
}

TEST(LevelImage, APixelIsTheMeanOfFour) {
    std::vector<std::uint8_t> pixels(320 * 240, 100);
    pixels[0] = 120;
    pixels[321] = 140;
    const LevelImage image = level_image(pixels, camera());
    EXPECT_EQ(image.width, 160);
    EXPECT_EQ(image.height, 120);
    EXPECT_FLOAT_EQ(image.row(0)[0], 115.0F);
    EXPECT_FLOAT_EQ(image.row(0)[1], 100.0F);
}

TEST(LevelImage, AnIdealCameraKeepsItsRays) {
    const Eigen::Vector2d at_px(220.5, 150.5);
    const Eigen::Vector2d seen = centre(level_image(spot(at_px), camera()));
    const Eigen::Vector2d ray = RayMapper(camera()).ray(at_px);
    EXPECT_NEAR(seen.x(), ray.x(), 0.002);
    EXPECT_NEAR(seen.y(), ray.y(), 0.002);
}

TEST(LevelImage, LensRollAndYawAreTakenOut) {
    CameraModel c = camera();
    c.distortion[0] = -0.2;
    c.mount.roll_rad = 0.06;
    c.mount.yaw_rad = -0.05;
    for (const Eigen::Vector2d& at_px : {Eigen::Vector2d(220.5, 150.5), Eigen::Vector2d(90.5, 60.5)}) {
        const Eigen::Vector2d seen = centre(level_image(spot(at_px), c));
        const Eigen::Vector2d ray = RayMapper(c).ray(at_px);
        EXPECT_NEAR(seen.x(), ray.x(), 0.004);
        EXPECT_NEAR(seen.y(), ray.y(), 0.004);
    }
}

TEST(LevelImage, FallOffTowardTheCornersIsTakenOut) {
    std::vector<std::uint8_t> pixels(320 * 240);
    for (int v = 0; v < 240; ++v) {
        for (int u = 0; u < 320; ++u) {
            const double r2 =
                (std::pow(u - 159.5, 2) + std::pow(v - 119.5, 2)) / (std::pow(160.0, 2) + std::pow(120.0, 2));
            pixels[static_cast<std::size_t>(v * 320 + u)] =
                static_cast<std::uint8_t>(std::lround(200.0 * (1.0 - 0.3 * r2)));
        }
    }
    const LevelImage image = level_image(pixels, camera(), 0.3);
    for (const int v : {0, 60, 119})
        for (const int u : {0, 80, 159}) EXPECT_NEAR(image.row(v)[u], 200.0, 1.0);
}

TEST(LevelCamera, RowsBelowTheHorizonGoBackAndForth) {
    LevelCamera c{80.0, 80.0, 79.5, 59.5, std::cos(0.3), std::sin(0.3), 0.6};
    for (const double v : {40.0, 60.0, 110.0}) EXPECT_NEAR(c.row_of(c.below_horizon(v)), v, 1e-9);
    EXPECT_GT(c.below_horizon(60.0), c.below_horizon(50.0));
    EXPECT_LT(c.floor_m(110.0), c.floor_m(60.0));
    EXPECT_GT(c.column_of(0.5, 60.0), c.cx_px);
}

}  // namespace
}  // namespace flownav::obstacles
