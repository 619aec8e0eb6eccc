#include "flownav/obstacles/points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"
#include "flownav/motion/ray_flow.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/truth.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using sim::View;

CameraModel shifted_camera() {
    CameraModel camera = testing::standard_camera();
    camera.mount.forward_m = 0.2;
    camera.mount.left_m = 0.1;
    return camera;
}

TEST(PointInRobot, DeeperIsAheadRightIsNegativeYAndLowerIsDown) {
    CameraMount mount;  // the camera is level
    const Vector3d ahead = point_in_robot({0, 0}, 2.0, mount);
    EXPECT_LT((ahead - Vector3d(2.0, 0.0, 0.9)).norm(), 1e-12);
    EXPECT_LT(point_in_robot({0.1, 0}, 2.0, mount).y(), -0.1);
    EXPECT_LT(point_in_robot({0, 0.1}, 2.0, mount).z(), 0.8);
}

TEST(PointInRobot, IsWhereTheCameraSeesIt) {
    const View view{shifted_camera(), {}, 0.0};
    const RayMapper mapper(view.camera);
    for (const Vector2d& at_px : {Vector2d(100, 200), Vector2d(320, 400), Vector2d(600, 300)}) {
        const auto sight = testing::look({}, view, at_px);
        ASSERT_TRUE(sight);
        const Vector3d p = point_in_robot(mapper.ray(at_px), sight->depth_m, view.camera.mount);
        EXPECT_LT((p - sight->point_m).norm(), 1e-9);
    }
}

/// Block of a fixed point that is seen at the beginning and at the end of a cycle, and its true position.
struct SeenPoint {
    View from{shifted_camera(), {}, 0.0};
    Pose2 T_from_to;
    RayFlow ray;
    Classification classification;

    SeenPoint(const Vector3d& point_m, double turn_rad, double chord_m)
        : T_from_to(along_arc(turn_rad, chord_m)) {
        const View to{from.camera, T_from_to, 0.0};
        const Vector2d at_px = *testing::project(from, point_m);
        const RayMapper mapper(from.camera);
        ray = motion::ray_flow({at_px, *testing::project(to, point_m) - at_px, {0.1, 0.1}, 1.0, true}, mapper,
                               mapper, Geometry::MidPoint);
        const EgoMotion motion = testing::exact_motion({}, T_from_to);
        const Derotation derotated(PlaneGeometry(from.camera.mount), motion.omega_rad, 0.0,
                                   Geometry::MidPoint);
        classification = classify(derotated(ray), {from.camera, motion, 1.0}, {});
    }

    std::optional<ObstaclePoint> point(const ObstacleParams& params = {}, double sigma_travel = 0.0) const {
        const Pose2 T_from_mid =
            along_arc(T_from_to.yaw_rad / 2, std::hypot(T_from_to.x_m, T_from_to.y_m) / 2);
        return obstacle_point(classification, {1, 2}, compose(inverse(T_from_to), T_from_mid),
                              from.camera.mount, sigma_travel, params);
    }
};

TEST(ObstaclePoint, LiesWhereThePointIsAtTheEndOfTheCycle) {
    for (const double turn_rad : {0.0, 4.8 * degree_rad, -4.8 * degree_rad}) {
        for (const Vector3d& p : {Vector3d(2.0, 0.5, 0.3), Vector3d(3.0, -0.8, 0.6)}) {
            const SeenPoint seen(p, turn_rad, 0.064);
            const auto found = seen.point();
            ASSERT_TRUE(found);
            const Vector2d truth = transform(inverse(seen.T_from_to), p.head<2>());
            EXPECT_LT((found->position_m.head<2>() - truth).norm(), 0.02);
            EXPECT_NEAR(found->position_m.z(), p.z(), 0.01);
            EXPECT_EQ(found->at_px, Vector2d(1, 2));
        }
    }
}

TEST(ObstaclePoint, ALeftTurnLeavesItFartherToTheRight) {
    const Vector3d ahead(2.0, 0.0, 0.3);
    EXPECT_LT(SeenPoint(ahead, 0.08, 0.064).point()->position_m.y(), -0.1);
    EXPECT_GT(SeenPoint(ahead, -0.08, 0.064).point()->position_m.y(), 0.1);
}

TEST(ObstaclePoint, ComesNearerWhileDriving) {
    EXPECT_NEAR(SeenPoint({2.0, 0.3, 0.3}, 0.0, 0.1).point()->position_m.x(), 1.9, 0.01);
}

TEST(ObstaclePoint, IsLeftOutBeyondTheLimits) {
    ObstacleParams params;
    params.range_max_m = 2.0;
    EXPECT_TRUE(SeenPoint({1.9, 0.3, 0.3}, 0.0, 0.064).point(params));
    EXPECT_FALSE(SeenPoint({2.1, 0.3, 0.3}, 0.0, 0.064).point(params));
    params.height_max_m = 0.5;
    EXPECT_TRUE(SeenPoint({1.9, 0.3, 0.4}, 0.0, 0.064).point(params));
    EXPECT_FALSE(SeenPoint({1.9, 0.3, 0.6}, 0.0, 0.064).point(params));
}

TEST(ObstaclePoint, IsLeftOutWhenItsDepthIsWorthless) {
    const SeenPoint seen({2.0, 0.3, 0.3}, 0.0, 0.064);
    EXPECT_TRUE(seen.point({}, 0.05));
    EXPECT_FALSE(seen.point({}, 0.15));
}

TEST(ObstaclePoint, ItsDeviationCombinesVectorAndSpeed) {
    SeenPoint seen({2.0, 0.0, 0.3}, 0.0, 0.064);
    const double range_m = (Vector2d(2.0 - 0.032, 0.0)).norm();
    seen.classification.sigma = 0.03 * seen.classification.inverse_depth;
    EXPECT_NEAR(seen.point({}, 0.04)->sigma_m, 0.05 * range_m, 0.002);
}

TEST(GroundPatch, CoversTheFloorOfItsBlock) {
    const View view{shifted_camera(), {}, 0.0};
    const Vector2d centre_px(300, 300);
    const auto patch = ground_patch(centre_px, RayMapper(view.camera), {}, 8.0);
    ASSERT_TRUE(patch);
    const auto near = testing::look({}, view, centre_px + Vector2d(0, 8));
    const auto far = testing::look({}, view, centre_px - Vector2d(0, 8));
    EXPECT_LT((patch->near_m - near->point_m.head<2>()).norm(), 1e-9);
    EXPECT_LT((patch->far_m - far->point_m.head<2>()).norm(), 1e-9);
    EXPECT_LT(patch->near_m.norm(), patch->far_m.norm());
}

TEST(GroundPatch, IsMovedToTheEndOfTheCycle) {
    const RayMapper mapper(testing::standard_camera());
    const Pose2 T_end_reference = inverse(along_arc(0.1, 0.2));
    const auto before = ground_patch({300, 300}, mapper, {}, 8.0);
    const auto after = ground_patch({300, 300}, mapper, T_end_reference, 8.0);
    ASSERT_TRUE(before && after);
    EXPECT_LT((after->far_m - transform(T_end_reference, before->far_m)).norm(), 1e-12);
    EXPECT_LT(after->far_m.x(), before->far_m.x());
}

TEST(GroundPatch, ThereIsNoneOverTheHorizonOrBeyondTheRange) {
    CameraModel flat = testing::standard_camera();
    flat.mount.pitch_rad = 5.0 * degree_rad;  // the horizon is row 186
    EXPECT_TRUE(ground_patch({300, 240}, RayMapper(flat), {}, 100.0));
    EXPECT_FALSE(ground_patch({300, 190}, RayMapper(flat), {}, 100.0));
    EXPECT_FALSE(ground_patch({300, 100}, RayMapper(flat), {}, 100.0));
    const RayMapper mapper(testing::standard_camera());
    EXPECT_TRUE(ground_patch({300, 300}, mapper, {}, 8.0));
    EXPECT_FALSE(ground_patch({300, 300}, mapper, {}, 1.0));
}

}  // namespace
}  // namespace flownav::obstacles
