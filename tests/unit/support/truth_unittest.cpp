#include "flownav/testing/truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"
#include "flownav/testing/camera.h"

namespace flownav::testing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

View standard_view(const Pose2& pose = {}) {
    return {standard_camera(), pose, 0.0};
}

/// A box 0.4 m wide and 1 m high; its near face is 2 m ahead of the robot.
World world_with_box(const Vector2d& velocity_mps = Vector2d::Zero()) {
    World world;
    Upright box;
    box.centre_m = {2.2, 0.0};
    box.half_x_m = box.half_y_m = 0.2;
    Solid solid = solid_of(box, {});
    solid.object = 3;
    set_velocity(solid, velocity_mps, 10.0);
    world.solids = {solid};
    return world;
}

/// Pixel of the centre of the near face.
Vector2d pixel_on_box() {
    return *project(standard_view(), {2.0, 0.0, 0.5});
}

TEST(Sight, DepthOfTheGroundIsTheHeightOverTheRaysFall) {
    const View view = standard_view({1.0, -2.0, 0.7});
    const RayMapper mapper(view.camera);
    const CameraMount& mount = view.camera.mount;
    for (const Vector2d& pixel : {Vector2d(0, 60), Vector2d(319.5, 239.5), Vector2d(600, 470)}) {
        const auto sight = look(World{}, view, pixel);
        ASSERT_TRUE(sight);
        // Equation (8)
        const double fall = std::cos(mount.pitch_rad) * mapper.ray(pixel).y() + std::sin(mount.pitch_rad);
        EXPECT_NEAR(sight->depth_m, mount.height_m / fall, 1e-12);
        EXPECT_NEAR(sight->point_m.z(), 0.0, 1e-12);
        EXPECT_EQ(sight->solid, floor_index);
    }
}

TEST(Sight, NothingIsSeenAboveTheHorizonOfAnEmptyWorld) {
    View view = standard_view();
    view.camera.mount.pitch_rad = 0.0;
    EXPECT_FALSE(look(World{}, view, Vector2d(320, 100)));
    EXPECT_TRUE(look(World{}, view, Vector2d(320, 400)));
}

TEST(Sight, PointsFallBackOnTheirPixelWithDistortionRollYawAndOffset) {
    View view = standard_view({0.3, 0.8, -1.9});
    view.camera.distortion = {-0.12, 0.03, 0.001, -0.002, 0.0};
    view.camera.mount.roll_rad = 4 * degree_rad;
    view.camera.mount.yaw_rad = -6 * degree_rad;
    view.camera.mount.forward_m = 0.2;
    view.camera.mount.left_m = -0.1;
    for (const Vector2d& pixel : {Vector2d(20, 120), Vector2d(320, 300), Vector2d(630, 470)}) {
        const auto sight = look(World{}, view, pixel);
        ASSERT_TRUE(sight);
        EXPECT_LT((*project(view, sight->point_m) - pixel).norm(), 1e-6);
    }
}

TEST(Sight, YawedCameraLooksToTheLeftAndRolledCameraTiltsToItsRight) {
    View view = standard_view();
    const Vector2d middle(319.5, 239.5);
    view.camera.mount.yaw_rad = 5 * degree_rad;
    EXPECT_NEAR(
        std::atan2(look(World{}, view, middle)->point_m.y(), look(World{}, view, middle)->point_m.x()),
        5 * degree_rad, 1e-9);
    view.camera.mount.yaw_rad = 0.0;
    view.camera.mount.roll_rad = 5 * degree_rad;
    // A camera rolled to its right sees nearer ground at the right end of a row than at the left end.
    EXPECT_LT(look(World{}, view, {600, 240})->point_m.x(), look(World{}, view, {40, 240})->point_m.x());
}

TEST(Sight, CameraAheadOfTheAxisSeesTheWorldFromThere) {
    View view = standard_view({0.0, 0.0, 90 * degree_rad});
    const Vector3d before = look(World{}, view, {320, 300})->point_m;
    view.camera.mount.forward_m = 0.3;
    view.camera.mount.left_m = 0.1;
    const Vector3d after = look(World{}, view, {320, 300})->point_m;
    EXPECT_LT((after - before - Vector3d(-0.1, 0.3, 0.0)).norm(), 1e-12);
}

TEST(Sight, NearestSurfaceIsSeenAndNamed) {
    const auto sight = look(world_with_box(), standard_view(), pixel_on_box());
    ASSERT_TRUE(sight);
    EXPECT_EQ(sight->solid, 0);
    EXPECT_EQ(sight->object, 3);
    EXPECT_LT((sight->point_m - Vector3d(2.0, 0.0, 0.5)).norm(), 1e-9);
}

TEST(Sight, CylinderIsSeenOnItsMantleAndOnItsTop) {
    World world;
    Upright drum;
    drum.shape = UprightShape::Cylinder;
    drum.centre_m = {2.0, 0.0};
    drum.half_x_m = 0.3;
    drum.z_high_m = 0.5;
    world.solids = {solid_of(drum, {})};
    const View view = standard_view();
    EXPECT_NEAR(look(world, view, *project(view, {1.7, 0.0, 0.25}))->point_m.x(), 1.7, 1e-9);
    EXPECT_NEAR(look(world, view, *project(view, {2.1, 0.1, 0.5}))->point_m.z(), 0.5, 1e-9);
    EXPECT_EQ(look(world, view, *project(view, {1.5, 0.5, 0.0}))->solid, floor_index);
}

TEST(ExactFlow, AgreesWithProjectingThePointItself) {
    const World world = world_with_box();
    const View from = standard_view({0.1, 0.05, 0.1});
    const View to = standard_view({0.18, 0.06, 0.14});
    for (const Vector2d& pixel : {Vector2d(100, 100), Vector2d(320, 200), Vector2d(500, 400)}) {
        const auto truth = exact_flow(world, from, to, pixel);
        ASSERT_TRUE(truth);
        const Vector2d expected = *project(to, look(world, from, pixel)->point_m) - pixel;
        EXPECT_LT((truth->flow_px - expected).norm(), 1e-12);
    }
}

TEST(ExactFlow, TurningLeftMovesThePictureToTheRight) {
    const auto truth =
        exact_flow(World{}, standard_view(), standard_view({0, 0, 1 * degree_rad}), {320, 240});
    EXPECT_GT(truth->flow_px.x(), 5.0);
    EXPECT_NEAR(truth->flow_px.y(), 0.0, 0.2);
}

TEST(ExactFlow, DrivingForwardMovesTheGroundDownAndOutwards) {
    const View from = standard_view();
    const View to = standard_view({0.05, 0, 0});
    EXPECT_GT(exact_flow(World{}, from, to, {319.5, 300})->flow_px.y(), 1.0);
    EXPECT_NEAR(exact_flow(World{}, from, to, {319.5, 300})->flow_px.x(), 0.0, 1e-9);
    EXPECT_LT(exact_flow(World{}, from, to, {100, 300})->flow_px.x(), -0.5);
    EXPECT_GT(exact_flow(World{}, from, to, {540, 300})->flow_px.x(), 0.5);
}

TEST(ExactFlow, RaisingTheCamerasViewMovesThePictureDown) {
    const View from = standard_view();
    View to = standard_view();
    to.camera.mount.pitch_rad -= 0.5 * degree_rad;
    EXPECT_GT(exact_flow(World{}, from, to, {320, 240})->flow_px.y(), 2.0);
    EXPECT_NEAR(exact_motion(from, to).pitch_rad, 0.5 * degree_rad, 1e-12);
}

TEST(ExactFlow, TiltingTheCameraToItsRightTurnsThePictureToTheLeft) {
    const View from = standard_view();
    View to = standard_view();
    to.camera.mount.roll_rad += 0.5 * degree_rad;
    EXPECT_LT(exact_flow(World{}, from, to, {600, 240})->flow_px.y(), -1.0);
    EXPECT_GT(exact_flow(World{}, from, to, {40, 240})->flow_px.y(), 1.0);
}

TEST(ExactFlow, NearerThingsMoveFasterThanTheGroundBehindThem) {
    const View from = standard_view();
    const View to = standard_view({0.05, 0, 0});
    const double on_box = exact_flow(world_with_box(), from, to, pixel_on_box())->flow_px.y();
    const double on_ground = exact_flow(World{}, from, to, pixel_on_box())->flow_px.y();
    EXPECT_GT(std::abs(on_box), std::abs(on_ground) + 0.2);
}

TEST(ExactFlow, MovingThingCarriesItsPointsAlong) {
    const World world = world_with_box({0.0, 0.5});
    const View from = standard_view();
    View to = standard_view();
    to.time_s = 0.1;
    const auto truth = exact_flow(world, from, to, pixel_on_box());
    ASSERT_TRUE(truth);
    const Vector2d expected = *project(to, {2.0, 0.05, 0.5}) - pixel_on_box();
    EXPECT_LT((truth->flow_px - expected).norm(), 1e-9);
    EXPECT_LT(truth->flow_px.x(), -5.0);
    EXPECT_FALSE(truth->occluded);
}

TEST(ExactFlow, GroundThatABoxHidesLaterIsMarkedOccluded) {
    const World world = world_with_box({0.0, 1.0});
    const View from = standard_view();
    View to = standard_view();
    to.time_s = 0.3;
    const Vector2d beside = *project(from, {2.6, 0.45, 0.0});
    EXPECT_EQ(exact_flow(world, from, to, beside)->sight.solid, floor_index);
    EXPECT_TRUE(exact_flow(world, from, to, beside)->occluded);
    EXPECT_FALSE(exact_flow(world, from, from, beside)->occluded);
}

TEST(ExactFlow, PointThatLeavesTheImageIsMarkedOutside) {
    const View from = standard_view();
    const View to = standard_view({0.2, 0, 0});
    EXPECT_FALSE(exact_flow(World{}, from, to, {320, 478})->inside);
    EXPECT_TRUE(exact_flow(World{}, from, to, {320, 240})->inside);
}

TEST(ExactFlow, PicturesAtRestInFieldsOfOtherParityDifferByHalfALine) {
    const CameraModel frame = standard_camera(768, 576);
    const View top{field_camera(frame, Parity::Top), {}, 0.0};
    const View bottom{field_camera(frame, Parity::Bottom), {}, 0.0};
    const Vector2d flow = exact_flow(World{}, top, bottom, {300, 150})->flow_px;
    EXPECT_NEAR(flow.x(), 0.0, 1e-9);
    EXPECT_NEAR(flow.y(), -0.5, 1e-9);
}

TEST(ExactMotion, IsTheArcBetweenTwoPoses) {
    const Pose2 from{3.0, -1.0, 2.0};
    const EgoMotion motion = exact_motion(from, compose(from, along_arc(0.08, 0.06)));
    EXPECT_NEAR(motion.omega_rad, 0.08, 1e-12);
    EXPECT_NEAR(motion.forward_m, 0.06, 1e-12);
}

}  // namespace
}  // namespace flownav::testing
