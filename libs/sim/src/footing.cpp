#include <algorithm>
#include <array>
#include <cmath>

#include "flownav/sim/ground.h"
#include "raycast/ground.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;

constexpr double wheel_forward_m = 0.15;
constexpr double wheel_left_m = 0.15;
constexpr double wheel_radius_m = 0.06;
constexpr double outline_step_m = 0.02;

/// Height of the lowest point of a wheel that rolls over the ground in the direction `heading`.
double wheel_height_m(const Ground& ground, const Vector2d& axis_m, const Vector2d& wheel_m,
                      const Vector2d& heading) {
    constexpr int samples = 12;
    double highest_m = -1e9;
    for (int i = -samples; i <= samples; ++i) {
        const double ahead_m = wheel_radius_m * i / samples;
        const Vector2d at_m = wheel_m + ahead_m * heading;
        const double steps_m = ground.steps_m(axis_m, at_m);
        const double rim_m = wheel_radius_m - std::sqrt(wheel_radius_m * wheel_radius_m - ahead_m * ahead_m);
        const double held_m = std::abs(steps_m) > step_max_m ? steps_m : 0.0;
        highest_m = std::max(highest_m, ground.height_m(at_m) - held_m - rim_m);
    }
    return highest_m;
}

}  // namespace

Eigen::Isometry3d ride_on_ground(const World& world, const Pose2& T_world_robot) {
    Eigen::Isometry3d T_flat_robot = Eigen::Isometry3d::Identity();
    if (world.ground.empty()) return T_flat_robot;
    const Ground ground(world);
    const Vector2d axis_m(T_world_robot.x_m, T_world_robot.y_m);
    const Vector2d heading(std::cos(T_world_robot.yaw_rad), std::sin(T_world_robot.yaw_rad));
    const auto wheel = [&](double forward, double left) {
        const Vector2d at(forward * wheel_forward_m, left * wheel_left_m);
        return wheel_height_m(ground, axis_m, transform(T_world_robot, at), heading);
    };
    const double front_left = wheel(1, 1);
    const double front_right = wheel(1, -1);
    const double rear_left = wheel(-1, 1);
    const double rear_right = wheel(-1, -1);
    const double nose_up =
        std::atan((front_left + front_right - rear_left - rear_right) / (4.0 * wheel_forward_m));
    const double left_up =
        std::atan((front_left + rear_left - front_right - rear_right) / (4.0 * wheel_left_m));
    T_flat_robot.translation().z() = (front_left + front_right + rear_left + rear_right) / 4.0;
    T_flat_robot.linear() = (Eigen::AngleAxisd(-nose_up, Eigen::Vector3d::UnitY()) *
                             Eigen::AngleAxisd(left_up, Eigen::Vector3d::UnitX()))
                                .toRotationMatrix();
    return T_flat_robot;
}

std::optional<Overhang> overhang(const World& world, const Polygon& footprint_m, const Pose2& T_world_robot) {
    if (world.ground.empty()) return std::nullopt;
    const Ground ground(world);
    const Vector2d axis_m(T_world_robot.x_m, T_world_robot.y_m);
    Overhang deepest;
    for (std::size_t i = 0, j = footprint_m.size() - 1; i < footprint_m.size(); j = i++) {
        const Vector2d side = footprint_m[i] - footprint_m[j];
        const int points = std::max(1, static_cast<int>(std::ceil(side.norm() / outline_step_m)));
        for (int k = 0; k < points; ++k) {
            const Vector2d at_m = transform(T_world_robot, footprint_m[j] + side * k / points);
            const double depth_m = -ground.steps_m(axis_m, at_m);
            if (depth_m > deepest.depth_m) deepest = {at_m, depth_m};
        }
    }
    if (deepest.depth_m <= step_max_m) return std::nullopt;
    return deepest;
}

}  // namespace flownav::sim
