#include "flownav/motion/ray_flow.h"

#include <gtest/gtest.h>

#include "exact_samples.h"
#include "flownav/math/units.h"
#include "flownav/testing/camera.h"

namespace flownav::motion {
namespace {

using Eigen::Vector2d;

TEST(RayFlow, IsTheDifferenceOfItsEndsAtTheirMiddle) {
    const RayMapper mapper(testing::standard_camera());
    const FlowVector vector{{400, 300}, {8, -6}, {0.2, 0.4}, 1.0, true};
    const RayFlow ray = ray_flow(vector, mapper, mapper, Geometry::MidPoint);
    EXPECT_LT((ray.flow - (mapper.ray({408, 294}) - mapper.ray({400, 300}))).norm(), 1e-12);
    EXPECT_LT((ray.at - mapper.ray({404, 297})).norm(), 1e-12);
    EXPECT_NEAR(ray.sigma.x(), 0.2 / mapper.camera().fx_px, 1e-12);
    EXPECT_NEAR(ray.sigma.y(), 0.4 / mapper.camera().fy_px, 1e-12);
}

TEST(RayFlow, IsTakenAtTheReferenceBlockInThePrintedMethod) {
    const RayMapper mapper(testing::standard_camera());
    const FlowVector vector{{400, 300}, {8, -6}, {0.2, 0.4}, 1.0, true};
    EXPECT_LT((ray_flow(vector, mapper, mapper, Geometry::Block).at - mapper.ray({400, 300})).norm(), 1e-12);
}

TEST(RayFlow, BetweenFieldsOfDifferentParityARobotAtRestSeesNoFlow) {
    const CameraModel frame = testing::standard_camera();
    const sim::View top{testing::field_camera(frame, testing::Parity::Top), {}, 0.0};
    const sim::View bottom{testing::field_camera(frame, testing::Parity::Bottom), {}, 0.0};
    for (const Vector2d& at_px : {Vector2d(320, 100), Vector2d(50, 200)}) {
        const auto truth = exact_flow({}, top, bottom, at_px);
        ASSERT_TRUE(truth);
        EXPECT_NEAR(truth->flow_px.y(), -0.5, 1e-9);  // in pixels the image jumps by half a line
        const RayFlow ray = ray_flow({at_px, truth->flow_px, {0.3, 0.3}, 1.0, true}, RayMapper(top.camera),
                                     RayMapper(bottom.camera), Geometry::MidPoint);
        EXPECT_LT(ray.flow.norm(), 1e-12);
    }
}

TEST(CameraTravel, CameraAheadOfTheAxisSwingsToTheLeftInALeftTurn) {
    CameraMount mount;
    mount.forward_m = 0.2;
    EXPECT_LT((camera_travel(mount, 0.05, 0.1) - Vector2d(0.05, 0.02)).norm(), 1e-12);
}

TEST(CameraTravel, CameraLeftOfTheAxisFallsBackInALeftTurn) {
    CameraMount mount;
    mount.left_m = 0.2;
    EXPECT_LT((camera_travel(mount, 0.05, 0.1) - Vector2d(0.03, 0.0)).norm(), 1e-12);
}

/// Largest error of the predicted flow over the blocks of a pair, pixels.
double worst_prediction_px(const testing::Pair& pair) {
    const CameraModel& camera = pair.from.camera;
    const RayMapper mapper(camera);
    const MotionPrediction motion{pair.truth.omega_rad, pair.truth.pitch_rad, pair.truth.forward_m};
    double worst_px = 0.0;
    for (const FlowVector& v : testing::exact_vectors(pair)) {
        const Vector2d at = mapper.ray(v.at_px);
        const Vector2d flow = GroundFlow(camera.mount, motion)(at);
        worst_px = std::max(worst_px, (mapper.pixel(at + flow) - v.at_px - v.flow_px).norm());
    }
    return worst_px;
}

TEST(PredictedGroundFlow, IsTheExactFlowOfARigidDriveAt30DegreesASecond) {
    const CameraModel camera = testing::standard_camera();
    EXPECT_LT(worst_prediction_px(testing::drive(camera, 0.4, 30.0, 1)), 0.02);
    EXPECT_LT(worst_prediction_px(testing::drive(camera, 0.4, -30.0, 4)), 0.5);
}

TEST(PredictedGroundFlow, KnowsTheSwingOfACameraOffTheAxis) {
    CameraModel camera = testing::standard_camera();
    camera.mount.forward_m = 0.2;
    camera.mount.left_m = -0.1;
    EXPECT_LT(worst_prediction_px(testing::drive(camera, 0.4, 30.0, 1)), 0.05);
}

TEST(PredictedGroundFlow, KnowsThePitch) {
    testing::Pair pair = testing::drive(testing::standard_camera(), 0.4, 0.0, 1);
    pair.to.camera.mount.pitch_rad -= 0.3 * degree_rad;
    pair.truth = testing::exact_motion(pair.from, pair.to);
    EXPECT_LT(worst_prediction_px(pair), 0.05);
}

}  // namespace
}  // namespace flownav::motion
