#include "flownav/testing/upright.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace flownav::testing {
namespace {

/// Movers start this much before time 0: a shutter opens before the first image.
constexpr double before_start_s = 1.0;

}  // namespace

Solid solid_of(const Upright& u, const Look& look) {
    Solid solid;
    const double height_m = u.z_high_m - u.z_low_m;
    if (u.shape == UprightShape::Box)
        solid.shape = sim::Box{{2.0 * u.half_x_m, 2.0 * u.half_y_m, height_m}};
    else
        solid.shape = sim::Cylinder{u.half_x_m, height_m};
    const double c = std::cos(u.yaw_rad);
    const double s = std::sin(u.yaw_rad);
    solid.T_world_solid.linear() << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
    solid.T_world_solid.translation() << u.centre_m.x(), u.centre_m.y(), 0.5 * (u.z_low_m + u.z_high_m);
    solid.look = look;
    return solid;
}

Upright upright_of(const Solid& solid) {
    const Eigen::Matrix3d& R = solid.T_world_solid.matrix().topLeftCorner<3, 3>();
    const Eigen::Vector3d centre_m = solid.T_world_solid.translation();
    if (R(2, 2) < 1.0 - 1e-12) throw std::invalid_argument(solid.name + ": is tilted");
    Upright u;
    double half_z_m = 0.0;
    if (const auto* box = std::get_if<sim::Box>(&solid.shape)) {
        u.half_x_m = 0.5 * box->size_m.x();
        u.half_y_m = 0.5 * box->size_m.y();
        half_z_m = 0.5 * box->size_m.z();
    } else if (const auto* cylinder = std::get_if<sim::Cylinder>(&solid.shape)) {
        u.shape = UprightShape::Cylinder;
        u.half_x_m = cylinder->radius_m;
        u.half_y_m = 0.0;
        half_z_m = 0.5 * cylinder->length_m;
    } else {
        throw std::invalid_argument(solid.name + ": is a sphere");
    }
    u.centre_m = centre_m.head<2>();
    u.z_low_m = centre_m.z() - half_z_m;
    u.z_high_m = centre_m.z() + half_z_m;
    u.yaw_rad = std::atan2(R(1, 0), R(0, 0));
    return u;
}

void set_velocity(Solid& solid, const Eigen::Vector2d& velocity_mps, double until_s) {
    Eigen::Isometry3d first = solid.T_world_solid;
    Eigen::Isometry3d last = solid.T_world_solid;
    first.translation().head<2>() -= before_start_s * velocity_mps;
    last.translation().head<2>() += until_s * velocity_mps;
    solid.script = {{-before_start_s, first}, {until_s, last}};
}

World at_time(const World& world, double time_s) {
    World moved = world;
    for (Solid& solid : moved.solids) {
        solid.T_world_solid = pose_at(solid, time_s);
        solid.script.clear();
    }
    return moved;
}

double distance_m(const Solid& solid, const Eigen::Vector2d& point_m) {
    const Upright u = upright_of(solid);
    const Eigen::Vector2d d = point_m - u.centre_m;
    if (u.shape == UprightShape::Cylinder) return std::max(0.0, d.norm() - u.half_x_m);
    const double c = std::cos(u.yaw_rad);
    const double s = std::sin(u.yaw_rad);
    const double x = std::max(0.0, std::abs(c * d.x() + s * d.y()) - u.half_x_m);
    const double y = std::max(0.0, std::abs(c * d.y() - s * d.x()) - u.half_y_m);
    return std::hypot(x, y);
}

}  // namespace flownav::testing
