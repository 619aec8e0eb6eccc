#include "drive_scene.h"

#include <cmath>

namespace flownav {
namespace {

using Eigen::Vector2d;

Polygon rectangle(const Eigen::Vector3d& size_m) {
    const double x = size_m.x() / 2;
    const double y = size_m.y() / 2;
    return {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
}

Polygon circle(double radius_m) {
    constexpr int corners = 24;
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle_rad = i * 2.0 * M_PI / corners;
        polygon.emplace_back(radius_m * std::cos(angle_rad), radius_m * std::sin(angle_rad));
    }
    return polygon;
}

/// The outline of a solid from above, in the world.
Polygon outline_m(const sim::Solid& solid, double time_s) {
    const auto* box = std::get_if<sim::Box>(&solid.shape);
    const auto* cylinder = std::get_if<sim::Cylinder>(&solid.shape);
    Polygon outline = box        ? rectangle(box->size_m)
                      : cylinder ? circle(cylinder->radius_m)
                                 : circle(std::get<sim::Sphere>(solid.shape).radius_m);
    const Eigen::Isometry3d pose = pose_at(solid, time_s);
    for (Vector2d& corner : outline) corner = (pose * Eigen::Vector3d(corner.x(), corner.y(), 0)).head<2>();
    return outline;
}

}  // namespace

report::DriveScene drive_scene(const drive::SimulatedDriveOptions& options,
                               const drive::DriveResult& result) {
    report::DriveScene scene;
    scene.footprint_m = options.config.navigation.robot.footprint_m;
    scene.start = options.start;
    scene.touched = result.outcome == drive::Outcome::Collision || result.outcome == drive::Outcome::Fell;
    for (const drive::DriveSample& sample : result.samples) {
        scene.believed.push_back(sample.T_map_robot);
        if (sample.truth_known) scene.true_way.push_back(sample.T_world_robot);
    }
    if (!result.samples.empty())
        scene.end = scene.true_way.empty() ? scene.believed.back() : scene.true_way.back();
    for (const sim::Solid& solid : options.world.solids)
        if (solid.solid) scene.outlines_m.push_back(outline_m(solid, result.time_s));
    scene.goals_m = options.goals_m;
    scene.goal_radius_m = options.success_radius_m;
    return scene;
}

}  // namespace flownav
