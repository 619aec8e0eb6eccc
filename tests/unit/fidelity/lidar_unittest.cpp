#include <gtest/gtest.h>

#include "flownav/testing/camera.h"
#include "lidar_score.h"

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

CameraModel tilted_camera() {
    CameraModel camera = testing::standard_camera();
    camera.mount.roll_rad = 0.03;
    camera.mount.forward_m = 0.2;
    camera.mount.left_m = -0.1;
    return camera;
}

pipeline::Step step_with(const std::vector<Vector3d>& points_m) {
    pipeline::Step step;
    for (const Vector3d& at_m : points_m) {
        step.obstacles.emplace_back();
        step.obstacles.back().position_m = at_m;
    }
    return step;
}

/// Returns on a pole of 1 m height.
std::vector<Vector3d> pole_at(double x_m, double y_m) {
    std::vector<Vector3d> scan_m;
    scan_m.reserve(10);
    for (int i = 0; i < 10; ++i) scan_m.emplace_back(x_m, y_m, 0.05 + 0.1 * i);
    return scan_m;
}

TEST(Lidar, APointOfTheFloorIsSeenWhereItsRayMeetsTheFloor) {
    const RayMapper mapper(tilted_camera());
    const CameraMount& mount = mapper.camera().mount;
    const Vector2d pixel_px = project(mapper, {2.5, 0.4, 0.0});
    const Vector2d ray = mapper.ray(pixel_px);
    const double a = std::cos(mount.pitch_rad), b = std::sin(mount.pitch_rad);
    const double depth_m = mount.height_m / (a * ray.y() + b);
    EXPECT_NEAR(depth_m * (a - b * ray.y()) + mount.forward_m, 2.5, 1e-9);
    EXPECT_NEAR(-depth_m * ray.x() + mount.left_m, 0.4, 1e-9);
}

TEST(Lidar, OnlyWhatStandsInTheCoveredAreaWithinRangeIsAnObstacle) {
    const RayMapper mapper(testing::standard_camera());
    const flow::BlockLayout layout = flow::place_blocks(mapper, {});
    EXPECT_FALSE(lidar_view(pole_at(2.6, 0.7), mapper, layout, 8.0).cells_m.empty());
    EXPECT_TRUE(lidar_view(pole_at(2.6, 0.7), mapper, layout, 2.0).cells_m.empty()) << "too far";
    EXPECT_TRUE(lidar_view(pole_at(2.6, 9.0), mapper, layout, 20.0).cells_m.empty()) << "out of view";
    EXPECT_TRUE(
        lidar_view({{2.6, 0.7, 0.1}, {2.6, 0.7, 0.2}, {2.6, 0.7, 0.25}}, mapper, layout, 8.0).cells_m.empty())
        << "too low";
    EXPECT_EQ(lidar_view(pole_at(2.6, 9.0), mapper, layout, 20.0).high_m.size(), 7U)
        << "but it confirms points";
}

TEST(Lidar, PointsAreRightNearReturnsAndCellsFoundNearPoints) {
    config::Config config;
    LidarJudge judge(testing::standard_camera(), config);
    judge.see(step_with({{2.8, 0.7, 0.5}, {5.0, 0.7, 0.5}}), pole_at(2.6, 0.7), {});
    EXPECT_EQ(judge.result().points_near.hits, 1);
    EXPECT_EQ(judge.result().points_near.all, 2);
    EXPECT_EQ(judge.result().cells_found.hits, 1);
    EXPECT_EQ(judge.result().cells_found.all, 1);
}

TEST(Lidar, PointsOfTheLastSecondCountWhereTheRobotHasLeftThem) {
    LidarJudge judge(testing::standard_camera(), config::Config{});
    judge.see(step_with({{5.6, 0.7, 0.5}}), {}, {});
    pipeline::Step later;
    later.timestamp_s = 0.5;
    later.T_start_robot = {3.0, 0.0, 0.0};
    judge.see(later, pole_at(2.6, 0.7), {});
    EXPECT_EQ(judge.result().cells_found.hits, 0);
    EXPECT_EQ(judge.result().cells_lately.hits, 1);
    later.timestamp_s = 2.0;
    judge.see(later, pole_at(2.6, 0.7), {});
    EXPECT_EQ(judge.result().cells_lately.hits, 1);
}

TEST(Lidar, ConnectedCellsAreOneThing) {
    std::vector<Vector3d> box_m;
    for (const double x_m : {2.6, 3.1, 3.6}) {
        for (const double y_m : {0.7, 1.1})
            for (const Vector3d& at_m : pole_at(x_m, y_m)) box_m.push_back(at_m);
    }
    LidarJudge judge(testing::standard_camera(), config::Config{});
    judge.see(step_with({{2.4, 0.7, 0.5}}), box_m, {});
    EXPECT_EQ(judge.result().things_found.all, 1);
    EXPECT_EQ(judge.result().things_found.hits, 1);
    EXPECT_LT(judge.result().cells_found.hits, judge.result().cells_found.all);
}

}  // namespace
}  // namespace flownav::fidelity
