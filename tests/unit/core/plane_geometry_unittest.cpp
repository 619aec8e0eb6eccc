#include "flownav/core/plane_geometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "flownav/math/units.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/truth.h"

namespace flownav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using sim::View;

constexpr double step = 1e-6;  // step of the numeric derivatives, m or rad
const std::vector<Vector2d> places = {{0.3, 0.2}, {-0.4, 0.1}, {0.05, -0.3}, {-0.2, -0.44}};

/// A camera whose pixels are normalised coordinates, so that projecting gives level rays.
CameraModel unit_camera() {
    CameraModel camera = testing::standard_camera();
    camera.fx_px = camera.fy_px = 1.0;
    camera.cx_px = camera.cy_px = 0.0;
    return camera;
}

/// The point at `depth_m` on the ray through `at`, in the robot frame.
Vector3d point_at(const CameraModel& camera, const Vector2d& at, double depth_m) {
    const double a = std::cos(camera.mount.pitch_rad);
    const double b = std::sin(camera.mount.pitch_rad);
    const Vector3d right(0, -1, 0), down(-b, 0, -a), forward(a, 0, -b);
    return Vector3d(camera.mount.forward_m, camera.mount.left_m, camera.mount.height_m) +
           depth_m * (at.x() * right + at.y() * down + forward);
}

/// Image velocity of a fixed point per step, by the difference of two views that are 2 steps apart.
Vector2d derivative(const View& before, const View& after, const Vector3d& point_m) {
    return (*testing::project(after, point_m) - *testing::project(before, point_m)) / (2 * step);
}

/// Image velocity for a robot that moves by `motion` per step.
Vector2d flow_of_robot(const CameraModel& camera, const Pose2& motion, const Vector2d& at, double depth_m) {
    const auto pose = [&](double s) { return Pose2{s * motion.x_m, s * motion.y_m, s * motion.yaw_rad}; };
    return derivative({camera, pose(-step), 0.0}, {camera, pose(step), 0.0}, point_at(camera, at, depth_m));
}

void expect_near(const Vector2d& p, const Vector2d& q) {
    EXPECT_NEAR(p.x(), q.x(), 1e-6);
    EXPECT_NEAR(p.y(), q.y(), 1e-6);
}

TEST(PlaneGeometry, APointOfTheFloorIsSeenWhereACameraProjectsIt) {
    const CameraModel camera = unit_camera();
    const CameraMount& mount = camera.mount;
    for (const double forward_m : {0.5, 2.0, 7.0}) {
        for (const double right_m : {-1.0, 0.0, 0.4}) {
            const auto at = PlaneGeometry(mount).floor_at(forward_m, right_m);
            ASSERT_TRUE(at);
            const Vector3d point_m(mount.forward_m + forward_m, mount.left_m - right_m, 0.0);
            expect_near(*at, *testing::project({camera, {}, 0.0}, point_m));
        }
    }
}

TEST(PlaneGeometry, FloorToTheRightIsSeenOnTheRightAndFloorBehindTheCameraIsNotSeen) {
    const PlaneGeometry plane(unit_camera().mount);
    EXPECT_GT(plane.floor_at(2.0, 0.5)->x(), 0.0);
    EXPECT_LT(plane.floor_at(2.0, -0.5)->x(), 0.0);
    EXPECT_GT(plane.floor_at(1.0, 0.0)->y(), plane.floor_at(2.0, 0.0)->y()) << "near floor is lower";
    EXPECT_FALSE(plane.floor_at(-20.0, 0.0));
}

TEST(PlaneGeometry, FieldEIsTheFlowOfDrivingForwardTimesDepth) {
    const CameraModel camera = unit_camera();
    for (const Vector2d& at : places) {
        const Vector2d e = PlaneGeometry(camera.mount).e(at);
        for (const double depth_m : {1.0, 3.0})
            expect_near(flow_of_robot(camera, {1, 0, 0}, at, depth_m), e / depth_m);
    }
}

TEST(PlaneGeometry, FieldEKnowsTheSwingToTheLeft) {
    const CameraModel camera = unit_camera();
    for (const Vector2d& at : places) {
        expect_near(flow_of_robot(camera, {0, 1, 0}, at, 2.0),
                    PlaneGeometry(camera.mount).e(at, {0, 1}) / 2.0);
    }
}

TEST(PlaneGeometry, FieldHIsTheFlowOfTurningLeftAtAnyDepth) {
    const CameraModel camera = unit_camera();
    for (const Vector2d& at : places) {
        for (const double depth_m : {1.0, 3.0})
            expect_near(flow_of_robot(camera, {0, 0, 1}, at, depth_m), PlaneGeometry(camera.mount).h(at));
    }
}

TEST(PlaneGeometry, CameraOffTheAxisSwingsWhileTheRobotTurns) {
    CameraModel camera = unit_camera();
    camera.mount.forward_m = 0.2;
    camera.mount.left_m = -0.1;
    const PlaneGeometry plane(camera.mount);
    for (const Vector2d& at : places)
        expect_near(flow_of_robot(camera, {0, 0, 1}, at, 1.5), plane.h(at) + plane.e(at, {0.1, 0.2}) / 1.5);
}

TEST(PlaneGeometry, FieldPIsTheFlowOfRaisingTheView) {
    const CameraModel camera = unit_camera();
    CameraModel raised = camera;
    CameraModel lowered = camera;
    raised.mount.pitch_rad -= step;
    lowered.mount.pitch_rad += step;
    for (const Vector2d& at : places) {
        expect_near(derivative({lowered, {}, 0}, {raised, {}, 0}, point_at(camera, at, 2.0)),
                    PlaneGeometry::p(at));
    }
}

TEST(PlaneGeometry, DrivingForwardMovesTheFloorDownAndOutward) {
    const PlaneGeometry plane(testing::standard_camera().mount);
    EXPECT_GT(plane.e({0.3, 0.2}).x(), 0);
    EXPECT_LT(plane.e({-0.3, 0.2}).x(), 0);
    EXPECT_GT(plane.e({0.3, 0.2}).y(), 0);
}

TEST(PlaneGeometry, TurningLeftMovesThePictureToTheRight) {
    const PlaneGeometry plane(testing::standard_camera().mount);
    EXPECT_GT(plane.h({0.0, 0.0}).x(), 0);
}

TEST(PlaneGeometry, RaisingTheViewMovesThePictureDown) {
    EXPECT_GT(PlaneGeometry::p({0.0, 0.0}).y(), 0);
}

TEST(PlaneGeometry, FocusOfExpansionLiesStraightAheadOnTheHorizon) {
    CameraMount mount;
    mount.pitch_rad = 25.0 * degree_rad;
    const Vector2d focus(0.0, -std::tan(mount.pitch_rad));
    EXPECT_NEAR(PlaneGeometry(mount).e(focus).norm(), 0.0, 1e-15);
    EXPECT_NEAR(PlaneGeometry(mount).below_horizon(focus), 0.0, 1e-15);
}

TEST(PlaneGeometry, GroundDepthIsThatOfAWorldOfFloor) {
    const CameraModel camera = testing::standard_camera();
    for (const Vector2d& pixel : {Vector2d(10, 100), Vector2d(320, 240), Vector2d(600, 470)}) {
        const auto sight = testing::look({}, {camera, {}, 0}, pixel);
        ASSERT_TRUE(sight);
        EXPECT_NEAR(PlaneGeometry(camera.mount).ground_inverse_depth(RayMapper(camera).ray(pixel)),
                    1 / sight->depth_m, 1e-12);
    }
}

TEST(PlaneGeometry, NothingOfTheGroundIsSeenFromTheHorizonUpward) {
    const PlaneGeometry plane(testing::standard_camera().mount);
    EXPECT_EQ(plane.ground_inverse_depth({0.1, -0.5}), 0.0);
    EXPECT_LT(plane.below_horizon({0.1, -0.5}), 0.0);
}

TEST(Deviation, IsTakenAlongAndAcrossADirection) {
    const Vector2d sigma(0.3, 0.1);
    EXPECT_NEAR(deviation_of_dot({2, 0}, sigma), 2 * 0.3, 1e-12);
    EXPECT_NEAR(deviation_of_cross({2, 0}, sigma), 2 * 0.1, 1e-12);
    EXPECT_NEAR(deviation_of_dot({0, -3}, sigma), 3 * 0.1, 1e-12);
    EXPECT_NEAR(deviation_of_cross({0, -3}, sigma), 3 * 0.3, 1e-12);
    EXPECT_NEAR(deviation_of_dot({1, 1}, sigma), std::sqrt(0.09 + 0.01), 1e-12);
}

TEST(Deviation, OnePixelOfAFieldIsTwiceAsHighAsWide) {
    const CameraModel field = testing::field_camera(testing::standard_camera(), testing::Parity::Top);
    EXPECT_NEAR(one_pixel(field).y(), 2 * one_pixel(field).x(), 1e-12);
}

TEST(GroundWindow, IsTheLowerThirdLessASixthOnEitherSide) {
    const CameraModel camera = testing::standard_camera();
    EXPECT_TRUE(in_ground_window({320, 400}, camera));
    EXPECT_TRUE(in_ground_window({110, 322}, camera));
    EXPECT_FALSE(in_ground_window({320, 318}, camera));
    EXPECT_FALSE(in_ground_window({100, 400}, camera));
    EXPECT_FALSE(in_ground_window({540, 400}, camera));
}

}  // namespace
}  // namespace flownav
