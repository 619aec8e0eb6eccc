#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/core/robot_model.h"
#include "flownav/sim/ray_caster.h"
#include "flownav/sim/truth.h"
#include "flownav/testing/camera.h"
#include "rendered.h"

namespace flownav::sim {
namespace {

using Eigen::Vector3d;

constexpr double degree = M_PI / 180.0;

Solid solid_at(const Shape& shape, const Vector3d& centre_m, double yaw_rad, const Look& look) {
    Solid solid;
    solid.shape = shape;
    solid.T_world_solid = Eigen::Translation3d(centre_m) * Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ());
    solid.look = look;
    return solid;
}

/// Every shape, upright and tilted, at rest and moving, none of it symmetric from left to right.
World world_of(Surface surface) {
    World world;
    world.floor = {surface, 120.0, 3};
    world.solids = {solid_at(Box{{0.4, 0.5, 0.6}}, {2.2, 0.5, 0.3}, 0.3, {surface, 60.0, 4}),
                    solid_at(Cylinder{0.15, 0.8}, {1.9, -0.4, 0.4}, 0.0, {surface, 200.0, 5}),
                    solid_at(Sphere{0.25}, {2.8, -0.1, 0.25}, 0.0, {surface, 30.0, 6}),
                    solid_at(Box{{0.1, 0.3, 1.2}}, {2.6, -0.9, 0.5}, 0.0, {surface, 160.0, 7}),
                    solid_at(Box{{0.2, 0.3, 0.3}}, {1.5, 0.0, 0.15}, 0.0, {surface, 230.0, 8}),
                    solid_at(Box{{0.2, 30.0, 8.0}}, {6.0, 0.0, 0.0}, 0.2, {surface, 90.0, 9})};
    world.solids[3].T_world_solid.rotate(Eigen::AngleAxisd(0.5, Vector3d::UnitX()));
    Eigen::Isometry3d later = world.solids[4].T_world_solid;
    later.translation().y() -= 0.4;
    world.solids[4].script = {{0.0, world.solids[4].T_world_solid}, {1.0, later}};
    Solid hidden = solid_at(Box{}, {1.2, 0.2, 0.5}, 0.0, {surface, 0.0, 1});
    hidden.visible = false;
    world.solids.push_back(hidden);
    return world;
}

CameraModel camera_of(const std::array<double, 5>& distortion = {}) {
    CameraModel camera = testing::standard_camera(320, 240);
    camera.cx_px += 9.3;
    camera.cy_px -= 6.2;
    camera.distortion = distortion;
    camera.mount.forward_m = 0.1;
    camera.mount.left_m = 0.05;
    camera.mount.yaw_rad = 3.0 * degree;
    camera.mount.roll_rad = -2.0 * degree;
    return camera;
}

constexpr Pose2 robot_pose{-0.2, 0.1, -0.05};
constexpr double moment_s = 0.6;

/// Mean absolute difference, grey levels.
double difference(const cv::Mat1b& a, const cv::Mat1b& b) {
    return cv::norm(a, b, cv::NORM_L1) / static_cast<double>(a.total());
}

struct Pictures {
    cv::Mat1b drawn;
    cv::Mat1b cast;
};

Pictures pictures_of(const World& world, const CameraModel& camera, const Pose2& pose = robot_pose) {
    CameraSimulator simulator(world, clean(camera, 4));
    RayCaster caster(world, camera);
    return {simulator.render(pose, moment_s), caster.render(pose, moment_s)};
}

/// Without texture the pictures differ at outlines only, by the samples of a pixel: 0.04 grey levels on
/// average. A shift of half a pixel makes 0.3, a mirrored picture 30.
void expect_same_outlines(const CameraModel& camera) {
    const World world = world_of(Surface::Plain);
    const Pictures pictures = pictures_of(world, camera);
    const double same = difference(pictures.drawn, pictures.cast);
    EXPECT_LT(same, 0.1);
    CameraModel wrong = camera;
    wrong.cx_px += 0.5;
    EXPECT_GT(difference(pictures.drawn, RayCaster(world, wrong).render(robot_pose, moment_s)), 3.0 * same);
    wrong = camera;
    wrong.cy_px += 0.5;
    EXPECT_GT(difference(pictures.drawn, RayCaster(world, wrong).render(robot_pose, moment_s)), 3.0 * same);
    cv::Mat1b mirrored;
    cv::flip(pictures.cast, mirrored, 1);
    EXPECT_GT(difference(pictures.drawn, mirrored), 100.0 * same);
}

TEST(Renderers, DrawTheSameOutlines) {
    expect_same_outlines(camera_of());
}

TEST(Renderers, DrawTheSameOutlinesThroughALens) {
    expect_same_outlines(camera_of({-0.2, 0.05, 0.001, 0.002, 0.0}));
}

TEST(Renderers, DrawTheSameSky) {
    World world;
    world.sky_grey = 40.0;
    CameraModel camera = camera_of();
    camera.mount.pitch_rad = -60.0 * degree;
    const Pictures pictures = pictures_of(world, camera);
    EXPECT_EQ(pictures.drawn(120, 160), 40);
    EXPECT_EQ(pictures.cast(120, 160), 40);
}

TEST(Renderers, HaveTheSameDepth) {
    const World world = world_of(Surface::Plain);
    const CameraModel camera = camera_of({-0.2, 0.05, 0.001, 0.002, 0.0});
    CameraSimulator simulator(world, clean(camera));
    RayCaster caster(world, camera);
    Renderer& drawn = simulator;
    Renderer& cast = caster;
    const cv::Mat1f of_drawn = drawn.depth_m(robot_pose, moment_s);
    const cv::Mat1f of_cast = cast.depth_m(robot_pose, moment_s);
    int apart = 0;
    for (int v = 0; v < of_drawn.rows; ++v)
        for (int u = 0; u < of_drawn.cols; ++u) apart += std::abs(of_drawn(v, u) - of_cast(v, u)) > 1e-4F;
    EXPECT_LE(apart, 3);  // rays along an outline
    EXPECT_GT(cv::countNonZero(of_cast), 70000);
}

/// The renderers' textures differ, and so do the corners that are tracked: camera_flow_unittest.cpp compares
/// the flow of both with the truth.
TEST(Renderers, ShowTheSameFlow) {
    const World world = world_of(Surface::Patterned);
    const CameraModel camera = camera_of();
    const Pose2 later{-0.14, 0.1, -0.03};
    const Pictures before = pictures_of(world, camera);
    const Pictures after = pictures_of(world, camera, later);
    const cv::Point2d drawn = mean_shift(before.drawn, after.drawn);
    const cv::Point2d cast = mean_shift(before.cast, after.cast);
    EXPECT_GT(cast.x, 4.0);
    EXPECT_NEAR(drawn.x, cast.x, 0.5);
    EXPECT_NEAR(drawn.y, cast.y, 0.5);
}

GroundPiece ground_at(const Vector3d& middle_m, double lean_rad, const Eigen::Vector2d& size_m,
                      const Look& look) {
    GroundPiece piece;
    piece.T_world_ground = Eigen::Translation3d(middle_m) * Eigen::AngleAxisd(lean_rad, Vector3d::UnitY());
    piece.size_m = size_m;
    piece.look = look;
    return piece;
}

/// Two treads down on the left, a kerb on the right, a ramp that rises behind them, and a post on the ramp.
World world_with_ground() {
    World world;
    world.floor = {Surface::Plain, 120.0, 3};
    world.ground = {ground_at({1.35, 0.4, -0.17}, 0.0, {0.3, 0.7}, {Surface::Plain, 180.0, 1}),
                    ground_at({1.65, 0.4, -0.34}, 0.0, {0.3, 0.7}, {Surface::Plain, 80.0, 1}),
                    ground_at({1.7, -0.5, 0.06}, 0.0, {0.5, 0.6}, {Surface::Plain, 200.0, 1}),
                    ground_at({3.2, 0.0, 0.12}, -0.12, {2.0, 2.4}, {Surface::Plain, 60.0, 1})};
    world.solids = {solid_at(Cylinder{0.1, 1.0}, {2.9, 0.2, 0.4}, 0.0, {Surface::Plain, 220.0, 1})};
    return world;
}

TEST(Renderers, DrawTheSameGround) {
    const World world = world_with_ground();
    for (const Pose2& pose : {robot_pose, Pose2{2.9, -0.1, 2.9}}) {
        const Pictures pictures = pictures_of(world, camera_of(), pose);
        EXPECT_LT(difference(pictures.drawn, pictures.cast), 0.15);
        World bare = world;
        bare.ground.clear();
        EXPECT_GT(difference(pictures.drawn, RayCaster(bare, camera_of()).render(pose, moment_s)), 3.0);
    }
}

TEST(Renderers, HaveTheSameDepthOfGround) {
    const World world = world_with_ground();
    CameraSimulator drawn(world, clean(camera_of()));
    RayCaster cast(world, camera_of());
    for (const Pose2& pose : {robot_pose, Pose2{2.9, -0.1, 2.9}}) {
        const cv::Mat1f of_drawn = drawn.depth_m(pose, moment_s);
        const cv::Mat1f of_cast = cast.depth_m(pose, moment_s);
        int apart = 0;
        for (int v = 0; v < of_drawn.rows; ++v)
            for (int u = 0; u < of_drawn.cols; ++u) apart += std::abs(of_drawn(v, u) - of_cast(v, u)) > 1e-4F;
        EXPECT_LE(apart, 8);
    }
}

/// A post and a slanting box under a light from the left, a lamp ahead, a mat, and the robot's own shadow.
World world_in_light(double soft_m) {
    World world;
    world.floor = {Surface::Plain, 120.0, 3};
    world.solids = {solid_at(Cylinder{0.1, 0.8}, {2.0, 0.3, 0.4}, 0.0, {Surface::Plain, 60.0, 1}),
                    solid_at(Box{{0.3, 0.4, 0.5}}, {2.3, -0.6, 0.25}, 0.4, {Surface::Plain, 160.0, 1}),
                    solid_at(Box{{0.4, 0.4, 0.05}}, {5.0, 0.2, 2.5}, 0.0, {Surface::Lamp, 250.0, 1}),
                    solid_at(Box{{0.6, 0.4, 0.001}}, {1.4, 0.2, 0.0005}, 0.2, {Surface::Plain, 180.0, 1})};
    world.solids[2].solid = world.solids[3].solid = false;
    world.ground = {ground_at({1.5, -0.7, -0.2}, 0.0, {0.4, 0.3}, {Surface::Plain, 90.0, 1})};
    world.shadow_light = ShadowLight{
        {-0.7, 0.6, 1.0}, 0.5, soft_m, ShadowBody{{{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}}, 1.2}};
    return world;
}

TEST(Renderers, DrawTheSameShadowsAndReflections) {
    for (const double soft_m : {0.0, 0.15}) {
        const World world = world_in_light(soft_m);
        const Pictures pictures = pictures_of(world, camera_of());
        const double same = difference(pictures.drawn, pictures.cast);
        EXPECT_LT(same, 0.2) << soft_m;
        World dark = world;
        dark.shadow_light.reset();
        EXPECT_GT(difference(pictures.drawn, RayCaster(dark, camera_of()).render(robot_pose, moment_s)), 1.0);
        World dull = world;
        dull.solids[2].look.surface = Surface::Plain;
        EXPECT_GT(difference(pictures.drawn, RayCaster(dull, camera_of()).render(robot_pose, moment_s)), 0.3);
    }
}

/// Grey at the pixel that shows a point of the floor.
int grey_at(const cv::Mat1b& picture, const CameraModel& camera, const Pose2& pose,
            const Eigen::Vector2d& at_m) {
    const auto pixel = project({camera, pose, 0.0}, {at_m.x(), at_m.y(), 0.0});
    return picture(static_cast<int>(std::lround(pixel->y())), static_cast<int>(std::lround(pixel->x())));
}

TEST(Renderers, ThrowShadowsAwayFromTheLight) {
    World world;
    world.floor = {Surface::Plain, 120.0, 3};
    world.solids = {solid_at(Cylinder{0.05, 0.5}, {1.8, 0.0, 0.25}, 0.0, {Surface::Plain, 60.0, 1})};
    const CameraModel camera = camera_of();
    for (const double side : {1.0, -1.0}) {
        world.shadow_light = ShadowLight{{0.0, side, 1.0}, 0.5, 0.0, {}};
        const cv::Mat1b picture = pictures_of(world, camera, {}).drawn;
        EXPECT_NEAR(grey_at(picture, camera, {}, {1.8, -side * 0.3}), 60, 2);
        EXPECT_NEAR(grey_at(picture, camera, {}, {1.8, side * 0.3}), 120, 2);
    }
}

TEST(Renderers, TheRobotsOwnShadowMovesWithIt) {
    World world;
    world.floor = {Surface::Plain, 120.0, 3};
    world.shadow_light = ShadowLight{{-1.0, 0.0, 1.0}, 0.5, 0.0, ShadowBody{RobotModel{}.footprint_m, 1.2}};
    const CameraModel camera = camera_of();
    for (const double x_m : {0.0, 0.7}) {
        const Pose2 pose{x_m, 0.0, 0.0};
        const cv::Mat1b picture = pictures_of(world, camera, pose).drawn;
        EXPECT_NEAR(grey_at(picture, camera, pose, {x_m + 1.3, 0.0}), 60, 2);
        EXPECT_NEAR(grey_at(picture, camera, pose, {x_m + 1.6, 0.0}), 120, 2);
        EXPECT_NEAR(grey_at(picture, camera, pose, {x_m + 1.3, 0.3}), 120, 2);
    }
}

TEST(Renderers, TheReflectionOfALampIsWhereItsMirrorImageIs) {
    World world;
    world.floor = {Surface::Tiles, 0.0, 3};  // black: only the reflection is seen
    world.solids = {solid_at(Box{{0.4, 0.4, 0.05}}, {5.0, 0.4, 2.5}, 0.0, {Surface::Lamp, 250.0, 1})};
    const CameraModel camera = camera_of();
    for (const Pose2& pose : {Pose2{}, Pose2{0.5, 0.2, 0.1}}) {
        const cv::Mat1b picture = pictures_of(world, camera, pose).drawn;
        double brightest = 0.0;
        cv::Point at;
        cv::minMaxLoc(picture(cv::Rect(0, 100, 320, 140)), nullptr, &brightest, nullptr, &at);
        const auto mirror = project({camera, pose, 0.0}, {5.0, 0.4, -2.5});
        EXPECT_NEAR(at.x, mirror->x(), 4.0);
        EXPECT_NEAR(at.y + 100, mirror->y(), 4.0);
        EXPECT_NEAR(brightest, 0.35 * 250.0, 3.0);
    }
}

TEST(Renderers, AGlassPaneIsSeenByNeither) {
    World world;
    world.floor.surface = Surface::Plain;
    Solid pane = solid_at(Box{{0.01, 2.0, 2.0}}, {1.5, 0.0, 1.0}, 0.0, {});
    world.solids = {pane};
    const cv::Mat1b opaque = pictures_of(world, camera_of()).drawn;
    world.solids[0].visible = false;
    const Pictures glass = pictures_of(world, camera_of());
    world.solids.clear();
    const Pictures nothing = pictures_of(world, camera_of());
    EXPECT_EQ(difference(glass.drawn, nothing.drawn), 0.0);
    EXPECT_EQ(difference(glass.cast, nothing.cast), 0.0);
    EXPECT_GT(difference(opaque, nothing.drawn), 5.0);
}

TEST(Renderers, OfOpenGlRefusesWaves) {
    World world;
    world.waves = {0.01, 1};
    EXPECT_THROW(CameraSimulator(world, clean(camera_of())), std::invalid_argument);
}

}  // namespace
}  // namespace flownav::sim
