#include "cast.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nearest_t = 1e-4;

/// Faces of the sides of a piece of ground, see PlanPiece.
constexpr std::array<Face, 4> face_of_side = {SideNegY, SidePosX, SidePosY, SideNegX};

/// Slab test. The ray is in the box's frame; false when it misses or starts inside.
bool meet(const Box& box, const Ray& ray, Hit& hit) {
    const Vector3d half = 0.5 * box.size_m;
    double enter = nearest_t;
    double leave = hit.t;
    int face = -1;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin_m[axis];
        const double d = ray.direction[axis];
        if (std::abs(d) < 1e-12) {
            if (std::abs(o) > half[axis]) return false;
            continue;
        }
        const bool rising = d > 0.0;
        const double in = ((rising ? -half : half)[axis] - o) / d;
        const double out = ((rising ? half : -half)[axis] - o) / d;
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

/// Where the ray enters |p| = radius, p the first `n` coordinates; infinite when it misses.
template <int n>
double enter_round(const Ray& ray, double radius_m) {
    const auto o = ray.origin_m.head<n>();
    const auto d = ray.direction.head<n>();
    const double a = d.squaredNorm();
    const double b = o.dot(d);
    const double c = o.squaredNorm() - radius_m * radius_m;
    const double root2 = b * b - a * c;
    if (root2 <= 0.0) return std::numeric_limits<double>::infinity();
    return (-b - std::sqrt(root2)) / a;
}

/// Mantle and ends of a cylinder, from outside.
bool meet(const Cylinder& cylinder, const Ray& ray, Hit& hit) {
    const double half_m = 0.5 * cylinder.length_m;
    const double o = ray.origin_m.z();
    const double d = ray.direction.z();
    const double enter = enter_round<2>(ray, cylinder.radius_m);
    if (enter > nearest_t && enter < hit.t && std::abs(o + enter * d) <= half_m) {
        hit.t = enter;
        hit.face = Side;
        return true;
    }
    if (d == 0.0) return false;
    const double end = ((d < 0.0 ? half_m : -half_m) - o) / d;
    if (end <= nearest_t || end >= hit.t) return false;
    const Vector2d at_m = ray.origin_m.head<2>() + end * ray.direction.head<2>();
    if (at_m.squaredNorm() > cylinder.radius_m * cylinder.radius_m) return false;
    hit.t = end;
    hit.face = d < 0.0 ? Top : Bottom;
    return true;
}

bool meet(const Sphere& sphere, const Ray& ray, Hit& hit) {
    const double enter = enter_round<3>(ray, sphere.radius_m);
    if (enter <= nearest_t || enter >= hit.t) return false;
    hit.t = enter;
    hit.face = Side;
    return true;
}

/// Sides of a box: each one has another piece of the texture.
Tangent tangent_of_side(const PlacedSolid& s, int face, const Vector3d& local, double height_m) {
    const int axis = face < SideNegY ? 0 : 1;
    const bool negative = face == SideNegX || face == SideNegY;
    const Vector3d outward = s.R_world_solid.col(axis);
    const double along_m = local[1 - axis] + 10.0 * face;
    return {negative ? Vector3d(-outward) : outward, s.R_world_solid.col(1 - axis), s.R_world_solid.col(2),
            Vector2d(along_m, height_m)};
}

Tangent tangent_of_mantle(const PlacedSolid& s, double radius_m, const Vector3d& local, double height_m) {
    const Vector3d outward = Vector3d(local.x(), local.y(), 0.0).normalized();
    const Vector3d around = Vector3d::UnitZ().cross(outward);
    const double angle = std::atan2(local.y(), local.x());
    return {s.R_world_solid * outward, s.R_world_solid * around, s.R_world_solid.col(2),
            Vector2d(radius_m * angle + 10.0, height_m)};
}

Tangent tangent_of_sphere(const PlacedSolid& s, double radius_m, const Vector3d& local) {
    const Vector3d outward = local.normalized();
    const Vector3d around = Vector3d::UnitZ().cross(outward).normalized();
    const Vector2d uv_m(radius_m * std::atan2(local.y(), local.x()) + 10.0,
                        radius_m * std::asin(std::clamp(outward.z(), -1.0, 1.0)));
    return {s.R_world_solid * outward, s.R_world_solid * around, s.R_world_solid * outward.cross(around),
            uv_m};
}

Tangent tangent_of_ground(const GroundPiece& piece, const Hit& hit, const Vector3d& point_m) {
    const Eigen::Matrix3d R = piece.T_world_ground.linear();
    const Vector3d local = piece.T_world_ground.inverse() * point_m;
    if (hit.face == Top) return {R.col(2), R.col(0), R.col(1), local.head<2>()};
    const int axis = hit.face < SideNegY ? 0 : 1;
    const bool negative = hit.face == SideNegX || hit.face == SideNegY;
    const Vector2d level = R.col(1 - axis).head<2>().normalized();
    const Vector3d along(level.x(), level.y(), 0.0);
    Vector3d outward = along.cross(Vector3d::UnitZ());
    if (outward.dot(R.col(axis)) < 0.0) outward = -outward;
    if (negative != hit.inner) outward = -outward;
    return {outward, along, Vector3d::UnitZ(), Vector2d(local[1 - axis] + 10.0 * hit.face, point_m.z())};
}

}  // namespace

std::vector<PlacedSolid> solids_at(const World& world, double time_s) {
    std::vector<PlacedSolid> solids;
    solids.reserve(world.solids.size());
    for (const Solid& s : world.solids) {
        const Eigen::Isometry3d T_world_solid = pose_at(s, time_s);
        solids.push_back({s.shape, T_world_solid.linear(), T_world_solid.translation(),
                          s.T_world_solid.translation().z(), s.visible});
    }
    return solids;
}

std::vector<int> visible_of(const std::vector<PlacedSolid>& solids) {
    std::vector<int> visible;
    for (std::size_t i = 0; i < solids.size(); ++i)
        if (solids[i].visible) visible.push_back(static_cast<int>(i));
    return visible;
}

Hit cast(const std::vector<PlacedSolid>& solids, const Ground& ground, const std::vector<int>& candidates,
         const Ray& ray) {
    Hit hit;
    const GroundHit below = ground.meet(ray);
    if (std::isfinite(below.t)) {
        const int face = below.side < 0 ? Top : face_of_side[static_cast<std::size_t>(below.side)];
        hit = {floor_index, face, below.t, below.piece, below.inner};
    }
    for (const int i : candidates) {
        const PlacedSolid& s = solids[static_cast<std::size_t>(i)];
        const Ray local{s.local_point(ray.origin_m), s.to_local(ray.direction)};
        if (!std::visit([&](const auto& shape) { return meet(shape, local, hit); }, s.shape)) continue;
        hit.solid = i;
        hit.piece = bare_floor;
    }
    return hit;
}

Tangent tangent_at(const std::vector<PlacedSolid>& solids, const std::vector<GroundPiece>& ground,
                   const Hit& hit, const Vector3d& point_m) {
    if (hit.piece != bare_floor)
        return tangent_of_ground(ground[static_cast<std::size_t>(hit.piece)], hit, point_m);
    if (hit.solid < 0) return {Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY(), point_m.head<2>()};
    const PlacedSolid& s = solids[static_cast<std::size_t>(hit.solid)];
    const Vector3d local = s.local_point(point_m);
    if (hit.face == Top || hit.face == Bottom) {
        const Vector3d up = s.R_world_solid.col(2);
        return {hit.face == Top ? up : Vector3d(-up), s.R_world_solid.col(0), s.R_world_solid.col(1),
                local.head<2>()};
    }
    const double height_m = local.z() + s.rest_z_m;
    if (const auto* cylinder = std::get_if<Cylinder>(&s.shape))
        return tangent_of_mantle(s, cylinder->radius_m, local, height_m);
    if (const auto* sphere = std::get_if<Sphere>(&s.shape))
        return tangent_of_sphere(s, sphere->radius_m, local);
    return tangent_of_side(s, hit.face, local, height_m);
}

RayFrame::RayFrame(const View& view) {
    const CameraMount& mount = view.camera.mount;
    const double a = std::cos(mount.pitch_rad);
    const double b = std::sin(mount.pitch_rad);
    const double c = std::cos(view.T_world_robot.yaw_rad);
    const double s = std::sin(view.T_world_robot.yaw_rad);
    const auto to_world = [&, c, s](double x, double y, double z) {
        const Vector3d flat = view.T_flat_robot.linear() * Vector3d(x, y, z);
        return Vector3d(c * flat.x() - s * flat.y(), s * flat.x() + c * flat.y(), flat.z());
    };
    const Vector3d eye = view.T_flat_robot * Vector3d(mount.forward_m, mount.left_m, mount.height_m);
    const Vector2d foot = transform(view.T_world_robot, Vector2d(eye.head<2>()));
    origin_m = {foot.x(), foot.y(), eye.z()};
    right = to_world(0.0, -1.0, 0.0);
    down = to_world(-b, 0.0, -a);
    forward = to_world(a, 0.0, -b);
}

}  // namespace flownav::sim
