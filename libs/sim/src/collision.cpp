#include "flownav/sim/collision.h"

#include <algorithm>
#include <limits>

#include "flownav/core/plane_geometry.h"
#include "flownav/sim/ground.h"
#include "flownav/sim/plan_view.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;

constexpr double lowest_m = 0.02;

/// True when two segments cross in a point inside both.
bool cross_each_other(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

bool outlines_cross(const Polygon& p, const Polygon& q) {
    for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) {
        for (std::size_t k = 0, l = q.size() - 1; k < q.size(); l = k++)
            if (cross_each_other(p[j], p[i], q[l], q[k])) return true;
    }
    return false;
}

/// Smallest signed distance of the corners of `q` to the outline of `p`.
double corners_to_outline_m(const Polygon& p, const Polygon& q) {
    double distance_m = std::numeric_limits<double>::infinity();
    for (const Vector2d& corner : q) distance_m = std::min(distance_m, signed_distance_m(p, corner));
    return distance_m;
}

double distance_m(const Polygon& footprint, const Disc& disc) {
    return signed_distance_m(footprint, disc.centre_m) - disc.radius_m;
}

double distance_m(const Polygon& footprint, const Polygon& other) {
    const double apart_m =
        std::min(corners_to_outline_m(footprint, other), corners_to_outline_m(other, footprint));
    return apart_m > 0.0 && outlines_cross(footprint, other) ? 0.0 : apart_m;
}

/// Point of a segment that is nearest to a polygon.
Vector2d nearest_on(const Vector2d& a, const Vector2d& b, const Polygon& polygon) {
    constexpr int pieces = 64;
    Vector2d best = a;
    for (int i = 1; i <= pieces; ++i) {
        const Vector2d at = a + (b - a) * i / pieces;
        if (signed_distance_m(polygon, at) < signed_distance_m(polygon, best)) best = at;
    }
    return best;
}

/// Distance of the footprint to a wall of the ground that it can reach from below without a step, when the
/// wall is too high for a wheel.
std::optional<double> distance_m(const World& world, const Vector2d& axis_m, const Polygon& footprint,
                                 const GroundWall& wall) {
    constexpr double before_m = 1e-3;
    if (std::max(wall.left_rise_m, wall.right_rise_m) <= step_max_m) return std::nullopt;
    const Vector2d left = wall.left_m.head<2>();
    const Vector2d right = wall.right_m.head<2>();
    const Vector2d along = (right - left).normalized();
    const Vector2d toward_low(along.y(), -along.x());
    if (toward_low.dot(axis_m - left) <= 0.0) return std::nullopt;
    const Vector2d nearest = nearest_on(left, right, footprint);
    const Vector2d inward = ((left + right) / 2 - nearest) / (right - left).norm();  // off the wall's ends
    const Vector2d before = nearest + before_m * (toward_low + inward);
    if (std::abs(ground_steps_m(world, axis_m, before)) > step_max_m) return std::nullopt;
    return distance_m(footprint, Polygon{left, right});
}

void look_at_ground(const World& world, const Vector2d& axis_m, const Polygon& footprint,
                    Clearance& nearest) {
    if (world.ground.empty()) return;
    for (const GroundWall& wall : ground_walls(world)) {
        const auto found_m = distance_m(world, axis_m, footprint, wall);
        if (found_m && *found_m < nearest.distance_m)
            nearest = {*found_m, world.ground[static_cast<std::size_t>(wall.piece)].name};
    }
}

}  // namespace

Clearance clearance(const World& world, const RobotModel& robot, const Pose2& T_world_robot, double time_s) {
    const Vector2d centre(T_world_robot.x_m, T_world_robot.y_m);
    const double reach_m = circumscribed_radius_m(robot.footprint_m);
    Polygon footprint;
    for (const Vector2d& corner : robot.footprint_m) footprint.push_back(transform(T_world_robot, corner));

    const double ground_m = world.ground.empty() ? 0.0 : ground_height_m(world, centre);
    Clearance nearest{std::numeric_limits<double>::infinity(), ""};
    for (const Solid& solid : world.solids) {
        if (!solid.solid) continue;
        const Eigen::Isometry3d pose = solid.script.empty() ? solid.T_world_solid : pose_at(solid, time_s);
        const double at_least_m =
            (pose.translation().head<2>() - centre).norm() - reach_m - bounding_radius_m(solid.shape);
        if (at_least_m >= nearest.distance_m) continue;
        const std::optional<PlanShape> plan =
            plan_view(solid.shape, pose, ground_m + lowest_m, ground_m + robot.height_m);
        if (!plan) continue;
        const double found_m =
            std::visit([&](const auto& shape) { return distance_m(footprint, shape); }, *plan);
        if (found_m < nearest.distance_m) nearest = {found_m, solid.name};
    }
    look_at_ground(world, centre, footprint, nearest);
    return nearest;
}

}  // namespace flownav::sim
