#include "raycast.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace flownav::testing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nearest_t = 1e-4;

/// Slab test in the box's own frame; false when the ray misses or starts inside.
bool meet_box(const Solid& s, const Ray& ray, Hit& hit) {
    const Vector3d o = s.local_point(ray.origin_m);
    const Vector3d d = s.to_local(ray.direction);
    const Vector3d low(-s.shape.half_x_m, -s.shape.half_y_m, s.shape.z_low_m);
    const Vector3d high(s.shape.half_x_m, s.shape.half_y_m, s.shape.z_high_m);
    double enter = nearest_t;
    double leave = hit.t;
    int face = -1;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(d[axis]) < 1e-12) {
            if (o[axis] < low[axis] || o[axis] > high[axis]) return false;
            continue;
        }
        const bool rising = d[axis] > 0.0;
        const double in = ((rising ? low : high)[axis] - o[axis]) / d[axis];
        const double out = ((rising ? high : low)[axis] - o[axis]) / d[axis];
        if (in > enter) {
            enter = in;
            const int negative = axis == 2 ? Bottom : 1 + 2 * axis;
            const int positive = axis == 2 ? Top : 2 + 2 * axis;
            face = rising ? negative : positive;
        }
        leave = std::min(leave, out);
        if (enter >= leave) return false;
    }
    if (face < 0) return false;
    hit.t = enter;
    hit.face = face;
    return true;
}

/// Mantle and top of an upright cylinder, from outside.
bool meet_cylinder(const Solid& s, const Ray& ray, Hit& hit) {
    const Vector3d& d = ray.direction;
    const Vector2d o = ray.origin_m.head<2>() - s.shape.centre_m;
    const double a = d.head<2>().squaredNorm();
    const double b = o.dot(d.head<2>());
    const double c = o.squaredNorm() - s.shape.half_x_m * s.shape.half_x_m;
    const double root2 = b * b - a * c;
    if (root2 <= 0.0) return false;
    const double enter = (-b - std::sqrt(root2)) / a;
    const double z = ray.origin_m.z() + enter * d.z();
    if (enter > nearest_t && enter < hit.t && z >= s.shape.z_low_m && z <= s.shape.z_high_m) {
        hit.t = enter;
        hit.face = Side;
        return true;
    }
    if (d.z() >= 0.0) return false;
    const double top = (s.shape.z_high_m - ray.origin_m.z()) / d.z();
    if (top <= nearest_t || top >= hit.t) return false;
    if ((o + top * d.head<2>()).squaredNorm() > s.shape.half_x_m * s.shape.half_x_m) return false;
    hit.t = top;
    hit.face = Top;
    return true;
}

Tangent tangent_of_side(const Solid& s, int face, const Vector3d& local) {
    switch (face) {
        case SideNegX:
            return {s.to_world(-Vector3d::UnitX()), s.to_world(Vector3d::UnitY()), Vector3d::UnitZ(),
                    Vector2d(local.y() + 10.0, local.z())};
        case SidePosX:
            return {s.to_world(Vector3d::UnitX()), s.to_world(Vector3d::UnitY()), Vector3d::UnitZ(),
                    Vector2d(local.y() + 20.0, local.z())};
        case SideNegY:
            return {s.to_world(-Vector3d::UnitY()), s.to_world(Vector3d::UnitX()), Vector3d::UnitZ(),
                    Vector2d(local.x() + 30.0, local.z())};
        case SidePosY:
            return {s.to_world(Vector3d::UnitY()), s.to_world(Vector3d::UnitX()), Vector3d::UnitZ(),
                    Vector2d(local.x() + 40.0, local.z())};
        default:
            break;
    }
    const Vector3d outward = Vector3d(local.x(), local.y(), 0.0).normalized();
    const Vector3d around = Vector3d::UnitZ().cross(outward);
    const double angle = std::atan2(local.y(), local.x());
    return {s.to_world(outward), s.to_world(around), Vector3d::UnitZ(),
            Vector2d(s.shape.half_x_m * angle + 10.0, local.z())};
}

}  // namespace

std::vector<Solid> solids_of(const World& world, double time_s) {
    std::vector<Solid> solids;
    solids.reserve(world.primitives.size());
    for (const Primitive& p : at_time(world, time_s).primitives)
        solids.push_back({p, std::cos(p.yaw_rad), std::sin(p.yaw_rad)});
    return solids;
}

Hit cast(const std::vector<Solid>& solids, const Floor& floor, const std::vector<int>& candidates,
         const Ray& ray) {
    Hit hit;
    if (ray.direction.z() < -1e-9) {
        hit.primitive = ground_primitive;
        hit.t = floor.meet(ray);
    }
    for (const int i : candidates) {
        const Solid& s = solids[static_cast<std::size_t>(i)];
        const bool met = s.shape.shape == Shape::Box ? meet_box(s, ray, hit) : meet_cylinder(s, ray, hit);
        if (met) hit.primitive = i;
    }
    return hit;
}

Tangent tangent_at(const std::vector<Solid>& solids, const Hit& hit, const Vector3d& point_m) {
    if (hit.primitive < 0)
        return {Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY(), point_m.head<2>()};
    const Solid& s = solids[static_cast<std::size_t>(hit.primitive)];
    const Vector3d local = s.local_point(point_m);
    if (hit.face == Top || hit.face == Bottom) {
        return {Vector3d::UnitZ(), s.to_world(Vector3d::UnitX()), s.to_world(Vector3d::UnitY()),
                local.head<2>()};
    }
    return tangent_of_side(s, hit.face, local);
}

RayFrame::RayFrame(const View& view) {
    const CameraMount& mount = view.camera.mount;
    const double a = std::cos(mount.pitch_rad);
    const double b = std::sin(mount.pitch_rad);
    const double c = std::cos(view.T_world_robot.yaw_rad);
    const double s = std::sin(view.T_world_robot.yaw_rad);
    const auto to_world = [c, s](double x, double y, double z) {
        return Vector3d(c * x - s * y, s * x + c * y, z);
    };
    const Vector2d foot = transform(view.T_world_robot, Vector2d(mount.forward_m, mount.left_m));
    origin_m = {foot.x(), foot.y(), mount.height_m};
    right = to_world(0.0, -1.0, 0.0);
    down = to_world(-b, 0.0, -a);
    forward = to_world(a, 0.0, -b);
}

}  // namespace flownav::testing
