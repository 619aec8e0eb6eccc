#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <vector>

#include "flownav/math/units.h"
#include "flownav/pipeline/pipeline.h"
#include "flownav/testing/scene.h"
#include "flownav/testing/truth.h"
#include "rendered.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A drive without noise, the same for both renderers.
testing::Scene quiet_scene(testing::SceneKind kind, int images,
                           const CameraModel& camera = testing::standard_camera()) {
    testing::SceneOptions options;
    options.kind = kind;
    options.images = images;
    options.camera = camera;
    options.effects.noise_sigma = 0.0;
    options.effects.vignetting = 0.0;
    return testing::make_scene(options);
}

double percentile(std::vector<double> values, double share) {
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// The world point at a pixel of a depth image.
Vector3d point_of(const sim::View& view, const Vector2d& pixel, double depth_m) {
    const CameraMount& mount = view.camera.mount;
    const Vector2d ray = RayMapper(view.camera).ray(pixel);
    const double s = std::sin(mount.pitch_rad);
    const double c = std::cos(mount.pitch_rad);
    const double ahead_m = depth_m * (c - s * ray.y());
    const Vector2d at =
        transform(view.T_world_robot, Vector2d(mount.forward_m + ahead_m, mount.left_m - depth_m * ray.x()));
    return {at.x(), at.y(), mount.height_m - depth_m * (s + c * ray.y())};
}

TEST(CameraFlow, OfItsDepthIsThatOfTheAnalyticRenderer) {
    const testing::Scene scene = quiet_scene(testing::SceneKind::Corridor, 60);
    const sim::View from = testing::nominal_view(scene, 30);
    const sim::View to = testing::nominal_view(scene, 34);
    CameraSimulator simulator(scene.world, clean(scene.options.camera));
    const cv::Mat1f depth = simulator.depth_m(scene.poses[30], scene.time_s(30));
    std::vector<double> errors_px;
    for (int v = 4; v < depth.rows; v += 9) {
        for (int u = 4; u < depth.cols; u += 9) {
            const auto truth = testing::exact_flow(scene.world, from, to, Vector2d(u, v));
            if (!truth || depth(v, u) <= 0.0F) continue;
            const auto seen = testing::project(to, point_of(from, Vector2d(u, v), depth(v, u)));
            errors_px.push_back((*seen - Vector2d(u, v) - truth->flow_px).norm());
        }
    }
    ASSERT_GT(errors_px.size(), 2000U);
    EXPECT_LT(percentile(errors_px, 0.99), 0.005);
    EXPECT_LT(percentile(errors_px, 1.0), 0.05);
}

/// Errors of the flow that a tracker finds between two images.
struct FlowErrors {
    std::vector<double> x_px;
    std::vector<double> y_px;
};

FlowErrors tracked(const cv::Mat1b& from, const cv::Mat1b& to, const testing::Scene& scene, int i, int j) {
    std::vector<cv::Point2f> points;
    std::vector<cv::Point2f> moved;
    std::vector<unsigned char> found;
    std::vector<float> residuals;
    cv::goodFeaturesToTrack(from, points, 600, 0.01, 10.0);
    const cv::TermCriteria fine(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001);
    cv::calcOpticalFlowPyrLK(from, to, points, moved, found, residuals, {15, 15}, 3, fine);
    const sim::View before = testing::nominal_view(scene, i);
    const sim::View after = testing::nominal_view(scene, j);
    FlowErrors errors;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto truth =
            testing::exact_flow(scene.world, before, after, Vector2d(points[k].x, points[k].y));
        if (found[k] == 0 || !truth || !truth->inside || truth->occluded) continue;
        const Vector2d error(moved[k].x - points[k].x - truth->flow_px.x(),
                             moved[k].y - points[k].y - truth->flow_px.y());
        if (error.norm() > 1.0) continue;  // outliers at the edges of objects
        errors.x_px.push_back(error.x());
        errors.y_px.push_back(error.y());
    }
    return errors;
}

void append(FlowErrors& all, const FlowErrors& more) {
    all.x_px.insert(all.x_px.end(), more.x_px.begin(), more.x_px.end());
    all.y_px.insert(all.y_px.end(), more.y_px.begin(), more.y_px.end());
}

double median_size_px(const FlowErrors& errors) {
    std::vector<double> sizes_px;
    for (std::size_t k = 0; k < errors.x_px.size(); ++k)
        sizes_px.push_back(std::hypot(errors.x_px[k], errors.y_px[k]));
    return percentile(sizes_px, 0.5);
}

TEST(CameraFlow, InItsPicturesIsThatOfTheAnalyticRenderer) {
    const testing::Scene scene = quiet_scene(testing::SceneKind::Corridor, 60);
    CameraSimulator simulator(scene.world, clean(scene.options.camera));
    FlowErrors rendered;
    FlowErrors analytic;
    for (const int i : {10, 30, 50}) {
        const int j = i + 3;
        append(rendered,
               tracked(picture_of(simulator.take(i, scene.poses[i], scene.time_s(i))),
                       picture_of(simulator.take(j, scene.poses[j], scene.time_s(j))), scene, i, j));
        append(analytic, tracked(picture_of(testing::make_field(scene, i)),
                                 picture_of(testing::make_field(scene, j)), scene, i, j));
    }
    ASSERT_GT(rendered.x_px.size(), 600U);
    ASSERT_GT(analytic.x_px.size(), 600U);
    EXPECT_NEAR(percentile(rendered.x_px, 0.5), percentile(analytic.x_px, 0.5), 0.01);
    EXPECT_NEAR(percentile(rendered.y_px, 0.5), percentile(analytic.y_px, 0.5), 0.01);
    EXPECT_LT(median_size_px(rendered), median_size_px(analytic) + 0.05);
}

/// Errors of the sensor over a drive, relative to ground truth.
struct SensorErrors {
    double yaw_rad = 0.0;          ///< over the whole drive
    double travel_share = 0.0;     ///< over the whole drive
    double omega_rms_radps = 0.0;  ///< per cycle
    int cycles = 0;
};

template <class Take>
SensorErrors sensor_errors(const testing::Scene& scene, const Take& take) {
    pipeline::State state{pipeline::Params{}};
    SensorErrors errors;
    int reference = 0;
    double squares = 0.0;
    double measured_m = 0.0;
    double true_m = 0.0;
    for (int i = 0; i < scene.images(); ++i) {
        const pipeline::Step& step = pipeline::step(state, take(i));
        if (!step.end_of_cycle) continue;
        const EgoMotion truth = testing::exact_motion(scene.poses[reference], scene.poses[i]);
        const double duration_s = scene.time_s(i) - scene.time_s(reference);
        reference = i;
        const double error = (step.motion.omega_rad - truth.omega_rad) / duration_s;
        squares += error * error;
        errors.yaw_rad += step.motion.omega_rad - truth.omega_rad;
        measured_m += step.motion.forward_m;
        true_m += truth.forward_m;
        ++errors.cycles;
    }
    errors.omega_rms_radps = std::sqrt(squares / std::max(errors.cycles, 1));
    errors.travel_share = measured_m / true_m - 1.0;
    return errors;
}

void compare_sensor(testing::SceneKind kind, int images) {
    const testing::Scene scene = quiet_scene(kind, images, testing::standard_camera(360, 270));
    CameraSimulator simulator(scene.world, clean(scene.options.camera));
    const SensorErrors rendered =
        sensor_errors(scene, [&](int i) { return simulator.take(i, scene.poses[i], scene.time_s(i)); });
    const SensorErrors analytic = sensor_errors(scene, [&](int i) { return testing::make_field(scene, i); });
    EXPECT_GT(rendered.cycles, images / 10);
    EXPECT_NEAR(rendered.omega_rms_radps, analytic.omega_rms_radps, 0.1 * degree_rad);
    EXPECT_LT(rendered.omega_rms_radps, 0.15 * degree_rad);
    EXPECT_NEAR(rendered.travel_share, 0.0, 0.005);
    EXPECT_NEAR(rendered.travel_share, analytic.travel_share, 0.005);
    EXPECT_NEAR(rendered.yaw_rad, analytic.yaw_rad, 0.2 * degree_rad);
}

TEST(CameraFlow, GivesTheSensorTheSameStraightDrive) {
    compare_sensor(testing::SceneKind::Straight, 25);
}

TEST(CameraFlow, GivesTheSensorTheSameCurves) {
    compare_sensor(testing::SceneKind::SCurve, 25);
}

}  // namespace
}  // namespace flownav::sim
