#include "flownav/core/camera_model.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <vector>

#include "flownav/core/plane_geometry.h"
#include "flownav/math/units.h"
#include "flownav/testing/camera.h"

namespace flownav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

CameraModel barrel_camera() {
    CameraModel camera = testing::standard_camera();
    camera.distortion = {-0.3, 0.08, 0.001, -0.002, 0.01};
    return camera;
}

CameraModel tilted_camera() {
    CameraModel camera = barrel_camera();
    camera.mount.roll_rad = 4.0 * degree_rad;
    camera.mount.yaw_rad = -7.0 * degree_rad;
    return camera;
}

/// Pixels on a grid over the whole image, including its border.
std::vector<Vector2d> grid_px(const CameraModel& camera) {
    std::vector<Vector2d> pixels;
    constexpr int steps = 8;
    for (int v = 0; v <= steps; ++v) {
        for (int u = 0; u <= steps; ++u)
            pixels.emplace_back(u * (camera.width_px - 1.0) / steps, v * (camera.height_px - 1.0) / steps);
    }
    return pixels;
}

/// Pinhole projection of a point of the robot frame by explicit rotations about each axis of the camera.
Vector2d project_pinhole(const CameraModel& camera, const Vector3d& point_m) {
    const CameraMount& m = camera.mount;
    Eigen::Matrix3d axes;  // columns: right, down, forward
    axes << 0, -std::sin(m.pitch_rad), std::cos(m.pitch_rad), -1, 0, 0, 0, -std::cos(m.pitch_rad),
        -std::sin(m.pitch_rad);
    axes = Eigen::AngleAxisd(m.yaw_rad, Vector3d::UnitZ()) * axes;
    axes = axes * Eigen::AngleAxisd(m.roll_rad, Vector3d::UnitZ()).toRotationMatrix();
    const Vector3d p = axes.transpose() * (point_m - Vector3d(m.forward_m, m.left_m, m.height_m));
    return {camera.fx_px * p.x() / p.z() + camera.cx_px, camera.fy_px * p.y() / p.z() + camera.cy_px};
}

TEST(RayMapper, MiddleOfAStraightCameraIsTheOrigin) {
    const CameraModel camera = testing::standard_camera();
    const RayMapper mapper(camera);
    EXPECT_NEAR(mapper.ray({camera.cx_px, camera.cy_px}).norm(), 0.0, 1e-15);
    const Vector2d right_below = mapper.ray({camera.cx_px + camera.fx_px, camera.cy_px + camera.fy_px});
    EXPECT_NEAR((right_below - Vector2d(1, 1)).norm(), 0.0, 1e-12);
}

TEST(RayMapper, RayOfAPixelFallsBackOnThePixelWithLensRollAndYaw) {
    for (const CameraModel& camera : {barrel_camera(), tilted_camera()}) {
        const RayMapper mapper(camera);
        for (const Vector2d& pixel : grid_px(camera))
            EXPECT_LT((mapper.pixel(mapper.ray(pixel)) - pixel).norm(), 1e-6) << pixel.transpose();
    }
}

TEST(RayMapper, AgreesWithOpenCvOnTheLens) {
    const CameraModel camera = barrel_camera();
    const RayMapper mapper(camera);
    std::vector<cv::Point2d> pixels;
    for (const Vector2d& pixel : grid_px(camera)) pixels.emplace_back(pixel.x(), pixel.y());
    const cv::Matx33d intrinsics(camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1);
    const std::vector<double> lens(camera.distortion.begin(), camera.distortion.end());
    std::vector<cv::Point2d> rays;
    cv::undistortPoints(pixels, rays, intrinsics, lens, cv::noArray(), cv::noArray(),
                        cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 500, 1e-12));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Vector2d ray = mapper.ray({pixels[i].x, pixels[i].y});
        EXPECT_NEAR(ray.x(), rays[i].x, 1e-6);
        EXPECT_NEAR(ray.y(), rays[i].y, 1e-6);
    }
}

TEST(RayMapper, LevelRayIsWhatTheCameraWithoutRollAndYawWouldSee) {
    CameraModel tilted = testing::standard_camera();
    tilted.mount.roll_rad = 5.0 * degree_rad;
    tilted.mount.yaw_rad = -8.0 * degree_rad;
    const CameraModel level = testing::standard_camera();
    const RayMapper mapper(tilted);
    for (const Vector3d& p : {Vector3d(2, 0.5, 0), Vector3d(4, -1, 0.3), Vector3d(1.2, 0, 1.1)}) {
        const Vector2d ray = mapper.ray(project_pinhole(tilted, p));
        EXPECT_LT((ray - RayMapper(level).ray(project_pinhole(level, p))).norm(), 1e-12) << p.transpose();
    }
}

TEST(RayMapper, PositiveYawLooksLeftSoStraightAheadIsRightOfTheMiddle) {
    CameraModel camera = testing::standard_camera();
    camera.mount.yaw_rad = 5.0 * degree_rad;
    const RayMapper mapper(camera);
    EXPECT_GT(mapper.pixel({0, 0}).x(), camera.cx_px + 20);
    EXPECT_LT(mapper.ray({camera.cx_px, camera.cy_px}).x(), -0.05);
}

TEST(RayMapper, PositiveRollTiltsToTheRightSoTheRightSideLooksDeeper) {
    CameraModel camera = testing::standard_camera();
    camera.mount.roll_rad = 5.0 * degree_rad;
    const RayMapper mapper(camera);
    EXPECT_GT(mapper.ray({camera.cx_px + 200, camera.cy_px}).y(), 0.01);
    EXPECT_LT(mapper.ray({camera.cx_px - 200, camera.cy_px}).y(), -0.01);
}

TEST(RayMapper, RowsOfBothFieldsOfAFrameLookWhereTheRowsOfTheFrameLook) {
    const CameraModel frame = testing::standard_camera();
    const RayMapper top(testing::field_camera(frame, testing::Parity::Top));
    const RayMapper bottom(testing::field_camera(frame, testing::Parity::Bottom));
    EXPECT_LT((top.ray({100, 50}) - RayMapper(frame).ray({100, 100})).norm(), 1e-12);
    EXPECT_LT((bottom.ray({100, 50}) - RayMapper(frame).ray({100, 101})).norm(), 1e-12);
}

TEST(SameGeometry, IgnoresTheHalfLineOfAField) {
    const CameraModel frame = testing::standard_camera();
    EXPECT_TRUE(same_geometry(testing::field_camera(frame, testing::Parity::Top),
                              testing::field_camera(frame, testing::Parity::Bottom)));
}

TEST(SameGeometry, NoticesEveryOtherChange) {
    const CameraModel camera = testing::standard_camera();
    const auto changed = [&](auto change) {
        CameraModel other = camera;
        change(other);
        return !same_geometry(camera, other);
    };
    EXPECT_TRUE(changed([](CameraModel& c) { c.width_px += 1; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.height_px += 1; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.fx_px += 0.01; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.fy_px += 0.01; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.cx_px += 0.01; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.cy_px += 1.0; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.distortion[4] = 1e-3; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.mount.height_m += 1e-3; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.mount.pitch_rad += 1e-4; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.mount.roll_rad += 1e-4; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.mount.yaw_rad += 1e-4; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.mount.forward_m += 1e-3; }));
    EXPECT_TRUE(changed([](CameraModel& c) { c.mount.left_m += 1e-3; }));
    EXPECT_FALSE(changed([](CameraModel&) {}));
}

}  // namespace
}  // namespace flownav
