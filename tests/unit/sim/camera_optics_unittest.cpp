#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "flownav/math/units.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/truth.h"
#include "rendered.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double bright = 220.0;
constexpr double dark = 40.0;

struct Optics {
    std::string name;
    CameraModel camera;
    bool interlaced = false;
    int image = 0;
};

void PrintTo(const Optics& optics, std::ostream* out) {
    *out << optics.name;
}

CameraModel tilted_camera() {
    CameraModel camera = testing::standard_camera(320, 240);
    camera.mount = {0.8, 12 * degree_rad, 3 * degree_rad, 0.0, 0.0, 0.0};
    return camera;
}

std::vector<Optics> all_optics() {
    std::vector<Optics> all = {{"Plain", tilted_camera()}};
    CameraModel camera = tilted_camera();
    camera.cx_px = 131.3;
    camera.cy_px = 144.8;
    camera.fx_px = 340.0;
    camera.fy_px = 290.0;
    all.push_back({"OffCentreAndUnequal", camera});
    camera.mount = {0.7, 8 * degree_rad, -6 * degree_rad, 9 * degree_rad, -0.25, 0.1};
    all.push_back({"Mounted", camera});
    camera.distortion = {-0.25, 0.08, 0.002, -0.003, -0.01};
    all.push_back({"Barrel", camera});
    camera.distortion = {0.15, 0.02, -0.001, 0.002, 0.0};
    all.push_back({"Cushion", camera});
    camera.height_px = 480;
    camera.fy_px = 600.0;
    camera.cy_px = 280.0;
    all.push_back({"TopField", camera, true, 4});
    all.push_back({"BottomField", camera, true, 7});
    return all;
}

/// A bright plate ahead of a dark wall; the scene has no other edges.
const Pose2 robot_pose{0.3, -0.2, 5 * degree_rad};
const Eigen::Isometry3d T_world_plate =
    Eigen::Translation3d(2.4, 0.05, 0.55) * Eigen::AngleAxisd(8 * degree_rad, Vector3d::UnitZ());
const Vector2d plate_half_m(0.3, 0.22);

World plate_world() {
    World world;
    world.floor = {Surface::Plain, dark, 1};
    Solid plate;
    plate.shape = Box{{1e-4, 2 * plate_half_m.x(), 2 * plate_half_m.y()}};
    plate.T_world_solid = T_world_plate;
    plate.look = {Surface::Plain, bright, 1};
    Solid wall;
    wall.shape = Box{{0.1, 60.0, 30.0}};
    wall.T_world_solid.translation() << 8.0, 0.0, 0.0;
    wall.look = {Surface::Plain, dark, 1};
    world.solids = {plate, wall};
    return world;
}

/// Position of the step between dark and bright in a line of pixels, from their brightness.
double step_px(const cv::Mat1b& line, int first, int last) {
    double light = 0.0;
    for (int i = first; i <= last; ++i) light += (line(i) - dark) / (bright - dark);
    const bool rises = line(last) > line(first);
    return rises ? last + 0.5 - light : first - 0.5 + light;
}

/// Mean distance of an edge of the image from its true place, along rows or columns.
double edge_error_px(const cv::Mat1b& picture, const sim::View& view, const Vector2d& from_m,
                     const Vector2d& to_m) {
    double sum = 0.0;
    int count = 0;
    constexpr int reach_px = 5;
    for (double t = 0.08; t < 0.92; t += 0.002) {
        const Vector2d at_m = (from_m + t * (to_m - from_m)).cwiseProduct(plate_half_m);
        const Vector2d pixel =
            testing::project(view, T_world_plate * Vector3d(0, at_m.x(), at_m.y())).value();
        const bool upright = from_m.x() == to_m.x();
        const Vector2d p = upright ? pixel : Vector2d(pixel.y(), pixel.x());
        const int across = static_cast<int>(std::lround(p.y()));
        if (std::abs(p.y() - across) > 0.1) continue;
        const cv::Mat1b line = upright ? picture.row(across) : cv::Mat1b(picture.col(across).t());
        const int middle = static_cast<int>(std::lround(p.x()));
        sum += step_px(line, middle - reach_px, middle + reach_px) - p.x();
        ++count;
    }
    EXPECT_GT(count, 20);
    return sum / count;
}

class CameraOptics : public ::testing::TestWithParam<Optics> {};

TEST_P(CameraOptics, EdgesLieWhereTheCalibrationHasThem) {
    const Optics& optics = GetParam();
    CameraSimParams params = clean(optics.camera, 3);
    params.interlaced = optics.interlaced;
    CameraSimulator simulator(plate_world(), params);
    const Field field = simulator.take(optics.image, robot_pose, 0.0);
    const cv::Mat1b picture = picture_of(field);
    const sim::View view{field.camera, robot_pose, 0.0};
    EXPECT_NEAR(edge_error_px(picture, view, {1, -1}, {1, 1}), 0.0, 0.05) << "left";
    EXPECT_NEAR(edge_error_px(picture, view, {-1, -1}, {-1, 1}), 0.0, 0.05) << "right";
    EXPECT_NEAR(edge_error_px(picture, view, {-1, 1}, {1, 1}), 0.0, 0.05) << "top";
    EXPECT_NEAR(edge_error_px(picture, view, {-1, -1}, {1, -1}), 0.0, 0.05) << "bottom";
}

INSTANTIATE_TEST_SUITE_P(All, CameraOptics, ::testing::ValuesIn(all_optics()),
                         [](const auto& optics) { return optics.param.name; });

TEST(CameraFields, HaveTheCamerasOfTheirParity) {
    CameraSimParams params = clean(testing::standard_camera(96, 72));
    params.camera.mount.yaw_rad = 0.1;
    params.interlaced = true;
    CameraSimulator simulator(World{}, params);
    for (const int image : {0, 1, 2, 3}) {
        const Field field = simulator.take(image, {}, 0.02 * image);
        const auto parity = image % 2 == 0 ? testing::Parity::Top : testing::Parity::Bottom;
        const CameraModel expected = testing::field_camera(params.camera, parity);
        EXPECT_EQ(field.image.height_px, 36);
        EXPECT_EQ(field.camera.cy_px, expected.cy_px);
        EXPECT_EQ(field.camera.fy_px, expected.fy_px);
        EXPECT_TRUE(same_geometry(field.camera, expected));
        EXPECT_DOUBLE_EQ(field.timestamp_s, sim_start_s + 0.02 * image);
    }
}

/// Depth in the level camera, as defined by the analytic truth.
double level_depth_m(const CameraModel& camera, const Vector2d& pixel, double depth_m) {
    const Eigen::Matrix3d R = level_rotation(camera.mount);
    const Vector3d mounted = R.transpose() * RayMapper(camera).ray(pixel).homogeneous();
    return depth_m / mounted.z();
}

TEST(CameraDepth, IsThatOfTheAnalyticRays) {
    testing::SceneOptions options;
    options.kind = testing::SceneKind::Corridor;
    options.camera = testing::standard_camera(320, 240);
    options.camera.mount.yaw_rad = 6 * degree_rad;
    options.camera.mount.roll_rad = -4 * degree_rad;
    options.camera.mount.forward_m = 0.2;
    options.camera.distortion = {-0.2, 0.05, 0.001, 0.002, 0.0};
    const testing::Scene scene = testing::make_scene(options);
    CameraSimulator simulator(scene.world, clean(options.camera));
    int compared = 0;
    int things = 0;
    for (const int i : {0, 60}) {
        const cv::Mat1f depth = simulator.depth_m(scene.poses[i], scene.time_s(i));
        for (int v = 3; v < 240; v += 7) {
            for (int u = 2; u < 320; u += 7) {
                const auto sight =
                    testing::look(scene.world, testing::nominal_view(scene, i), Vector2d(u, v));
                const double own = level_depth_m(options.camera, Vector2d(u, v), depth(v, u));
                EXPECT_NEAR(own, sight ? sight->depth_m : 0.0, 1e-4 * (1.0 + own)) << u << ' ' << v;
                ++compared;
                things += sight && sight->solid >= 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(compared, 3000);
    EXPECT_GT(things, 300);
}

TEST(CameraDepth, FollowsWhatMoves) {
    World world;
    Solid box;
    box.shape = Box{{0.4, 0.4, 1.0}};
    box.T_world_solid.translation() << 3.0, 0.0, 0.5;
    Eigen::Isometry3d nearer = box.T_world_solid;
    nearer.translation().x() = 2.0;
    box.script = {{0.0, box.T_world_solid}, {2.0, nearer}};
    world.solids = {box};
    CameraModel camera = testing::standard_camera(64, 48);
    camera.mount = {0.5, 0.0, 0.0, 0.0, 0.0, 0.0};
    CameraSimulator simulator(world, clean(camera));
    EXPECT_NEAR(simulator.depth_m({}, 0.0).at<float>(24, 32), 2.8, 1e-5);
    EXPECT_NEAR(simulator.depth_m({}, 1.0).at<float>(24, 32), 2.3, 1e-5);
    EXPECT_NEAR(simulator.depth_m({}, 5.0).at<float>(24, 32), 1.8, 1e-5);
}

}  // namespace
}  // namespace flownav::sim
