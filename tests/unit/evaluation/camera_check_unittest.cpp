#include "flownav/evaluation/camera_check.h"

#include <gtest/gtest.h>

#include "flownav/math/units.h"
#include "flownav/pipeline/pipeline.h"
#include "flownav/testing/scene.h"

namespace flownav::evaluation {
namespace {

/// What the checker says of a drive that is seen with a wrong mount.
CameraCheck check_of(double pitch_error_deg, double height_factor, double odometry_factor = 1.0,
                     double speed_mps = 0.6) {
    testing::SceneOptions options;
    options.kind = testing::SceneKind::Straight;
    options.images = 100;
    options.speed_mps = speed_mps;
    options.camera = testing::standard_camera(320, 240);
    const testing::Scene scene = testing::make_scene(options);
    pipeline::Params params;
    params.flow.blocks = 200;
    params.rate.cycle_images = 4;
    pipeline::State state(params);
    CameraChecker checker(params.motion.geometry);
    PoseTrack odometry;
    for (int i = 0; i < scene.images(); ++i) {
        Field field = testing::make_field(scene, i);
        field.camera.mount.pitch_rad += pitch_error_deg * degree_rad;
        field.camera.mount.height_m *= height_factor;
        checker.take(field, pipeline::step(state, field));
        const Pose2 pose = scene.poses[static_cast<std::size_t>(i)];
        odometry.add(field.timestamp_s,
                     {pose.x_m * odometry_factor, pose.y_m * odometry_factor, 0, pose.yaw_rad, 0, 0});
    }
    odometry.finish();
    return checker.result(odometry);
}

TEST(CameraCheck, ARightPoseIsConsistent) {
    const CameraCheck check = check_of(0.0, 1.0);
    EXPECT_STREQ(check.verdict, "consistent");
    EXPECT_TRUE(check.warnings.empty());
    EXPECT_LT(std::abs(check.angles.correction_rad[0]), 0.5 * degree_rad);
    ASSERT_TRUE(check.scale);
    EXPECT_NEAR(check.scale->ratio, 1.0, 0.02);
}

TEST(CameraCheck, APitchThatIsFiveDegreesOffIsReportedWithTheRightOne) {
    const CameraCheck check = check_of(5.0, 1.0);
    EXPECT_STREQ(check.verdict, "pose_contradicts_flow");
    EXPECT_NEAR(check.angles.correction_rad[0], -5.0 * degree_rad, 1.0 * degree_rad);
    ASSERT_EQ(check.warnings.size(), 1U);
    EXPECT_NE(check.warnings.front().find("camera.pitch_deg = 30.00"), std::string::npos);
    EXPECT_NE(check.warnings.front().find("flownav-calibrate"), std::string::npos);
}

TEST(CameraCheck, AHeightThatContradictsTheOdometryIsReportedWithTheRightOne) {
    const CameraCheck check = check_of(0.0, 2.0);
    EXPECT_STREQ(check.verdict, "height_contradicts_odometry");
    ASSERT_EQ(check.warnings.size(), 1U);
    EXPECT_NE(check.warnings.front().find("height looks like 0.9"), std::string::npos)
        << check.warnings.front();
    EXPECT_EQ(check.warnings.front().find("centimetres"), std::string::npos);
}

TEST(CameraCheck, AHundredTimesTooHighLooksLikeCentimetres) {
    const CameraCheck check = check_of(0.0, 1.0, 0.01);
    ASSERT_FALSE(check.scale);  // too slow to count as driving
    const CameraCheck far = check_of(0.0, 20.0, 0.2);
    ASSERT_EQ(far.warnings.size(), 1U);
    EXPECT_NE(far.warnings.front().find("centimetres"), std::string::npos) << far.warnings.front();
}

TEST(CameraCheck, ARobotThatCrawlsDeterminesNoPose) {
    const CameraCheck check = check_of(0.0, 1.0, 1.0, 0.02);
    EXPECT_STREQ(check.verdict, "not_determined");
    EXPECT_EQ(check.pairs, 0);
    EXPECT_TRUE(check.warnings.empty());
}

TEST(CameraCheck, WithoutADriveNothingIsDetermined) {
    const CameraCheck check = CameraChecker(Geometry::MidPoint).result({});
    EXPECT_STREQ(check.verdict, "not_determined");
    EXPECT_FALSE(check.angles_known);
    EXPECT_TRUE(check.warnings.empty());
}

}  // namespace
}  // namespace flownav::evaluation
