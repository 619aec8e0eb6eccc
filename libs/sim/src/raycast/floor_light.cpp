#include "floor_light.h"

#include <algorithm>
#include <cmath>

#include "flownav/math/convex_hull.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int rim_points = 12;
constexpr double blur_rad = 0.03;  ///< half width of a reflection in a floor, seen from the eye
constexpr double reach_sigmas = 3.5;

/// Share of a lamp's light that the floor reflects toward the eye.
double gloss_of(Surface surface) {
    switch (surface) {
        case Surface::Tiles:
        case Surface::Stoneware:
            return 0.35;
        case Surface::Lino:
        case Surface::Marbled:
            return 0.25;
        case Surface::Plain:
            return 0.20;
        default:
            return 0.0;
    }
}

Vector3d on_circle(int i) {
    const double angle = 2.0 * M_PI * i / rim_points;
    return {std::cos(angle), std::sin(angle), 0.0};
}

/// Points of a shape whose hull throws its shadow, in its frame; `towards` is the direction of the light
/// there.
std::vector<Vector3d> outline_of(const Box& box, const Vector3d& /*towards*/) {
    std::vector<Vector3d> points;
    for (unsigned i = 0; i < 8; ++i) {
        const Vector3d sign((i & 1U) != 0 ? 0.5 : -0.5, (i & 2U) != 0 ? 0.5 : -0.5,
                            (i & 4U) != 0 ? 0.5 : -0.5);
        points.emplace_back(sign.cwiseProduct(box.size_m));
    }
    return points;
}

std::vector<Vector3d> outline_of(const Cylinder& cylinder, const Vector3d& /*towards*/) {
    std::vector<Vector3d> points;
    for (int i = 0; i < rim_points; ++i) {
        for (const double z_m : {-cylinder.length_m / 2, cylinder.length_m / 2})
            points.emplace_back(cylinder.radius_m * on_circle(i) + Vector3d(0.0, 0.0, z_m));
    }
    return points;
}

std::vector<Vector3d> outline_of(const Sphere& sphere, const Vector3d& towards) {
    const Eigen::Quaterniond turned = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), towards);
    std::vector<Vector3d> points;
    for (int i = 0; i < 2 * rim_points; i += 2)
        points.emplace_back(sphere.radius_m * (turned * on_circle(i / 2)));
    return points;
}

double radius_of(const Shape& shape) {
    if (const auto* box = std::get_if<Box>(&shape)) return box->size_m.head<2>().minCoeff() / 2;
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->radius_m;
    return std::get<Sphere>(shape).radius_m;
}

}  // namespace

Look wall_look(const GroundPiece& piece) {
    Look look = piece.look;
    look.grey *= wall_shade;
    return look;
}

FloorLight::FloorLight(const World& world, const Pose2& T_world_robot, double time_s, const Vector3d& eye_m) {
    add_shadows(world, T_world_robot, time_s);
    add_spots(world, time_s, eye_m);
}

void FloorLight::add_shadows(const World& world, const Pose2& T_world_robot, double time_s) {
    if (!world.shadow_light) return;
    const ShadowLight& light = *world.shadow_light;
    for (const Solid& solid : world.solids) {
        if (!solid.visible || !solid.solid || solid.look.surface == Surface::Lamp) continue;
        const Eigen::Isometry3d pose = pose_at(solid, time_s);
        const Vector3d towards = (pose.linear().transpose() * light.towards).normalized();
        std::vector<Vector3d> points =
            std::visit([&](const auto& shape) { return outline_of(shape, towards); }, solid.shape);
        for (Vector3d& point : points) point = pose * point;
        add_shadow(light, points);
    }
    if (!light.robot) return;
    std::vector<Vector3d> body;
    for (const Vector2d& corner : light.robot->footprint_m) {
        const Vector2d at = transform(T_world_robot, corner);
        for (const double z_m : {0.0, light.robot->height_m}) body.emplace_back(at.x(), at.y(), z_m);
    }
    add_shadow(light, body);
}

/// Parts below the floor throw no shadow.
void FloorLight::add_shadow(const ShadowLight& light, const std::vector<Vector3d>& points_m) {
    std::vector<Vector2d> thrown;
    double highest_m = 0.0;
    for (const Vector3d& p : points_m) {
        highest_m = std::max(highest_m, p.z());
        thrown.emplace_back(p.head<2>() - light.towards.head<2>() / light.towards.z() * std::max(p.z(), 0.0));
    }
    const Polygon outline = convex_hull(std::move(thrown));
    if (outline.size() < 3 || highest_m <= 0.0) return;
    FloorShadow shadow;
    shadow.loss = light.loss;
    shadow.soft_m = light.soft_m;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const Vector2d along = outline[i] - outline[j];
        const Vector2d outward = Vector2d(along.y(), -along.x()).normalized();
        shadow.sides.emplace_back(outward.x(), outward.y(), outward.dot(outline[i]));
        shadow.extent_m.extend(outline[i]);
    }
    const Vector2d edge = Vector2d::Constant(light.soft_m);
    shadow.extent_m = Eigen::AlignedBox2d(shadow.extent_m.min() - edge, shadow.extent_m.max() + edge);
    shadows_.push_back(std::move(shadow));
}

/// A level lamp has its mirror image below the floor; the spot is where the line of sight to it passes the
/// floor.
void FloorLight::add_spots(const World& world, double time_s, const Vector3d& eye_m) {
    const double gloss = gloss_of(world.floor.surface);
    if (gloss == 0.0 || eye_m.z() <= 0.0) return;
    for (const Solid& solid : world.solids) {
        if (solid.look.surface != Surface::Lamp || !solid.visible) continue;
        const Vector3d lamp_m = pose_at(solid, time_s).translation();
        if (lamp_m.z() <= 0.0) continue;
        const double share = eye_m.z() / (eye_m.z() + lamp_m.z());
        FloorSpot spot;
        spot.centre_m = eye_m.head<2>() + share * (lamp_m - eye_m).head<2>();
        spot.grey = gloss * solid.look.grey;
        const Vector2d sight_m = spot.centre_m - eye_m.head<2>();
        const double distance_m = std::hypot(sight_m.norm(), eye_m.z());
        const double lamp_sigma_m = share * radius_of(solid.shape) / 2;
        const double across_m = std::hypot(lamp_sigma_m, blur_rad * distance_m);
        const double along_m = std::hypot(lamp_sigma_m, blur_rad * distance_m * distance_m / eye_m.z());
        const Vector2d along = sight_m.norm() > 1e-9 ? Vector2d(sight_m.normalized()) : Vector2d::UnitX();
        spot.to_sigmas << along.x() / along_m, along.y() / along_m, -along.y() / across_m,
            along.x() / across_m;
        spot.reach_m = reach_sigmas * along_m;
        spots_.push_back(spot);
    }
}

double FloorLight::lit(double grey, const Vector2d& at_m, const Vector2d& right_m,
                       const Vector2d& down_m) const {
    for (const FloorShadow& shadow : shadows_) {
        if (!shadow.extent_m.contains(at_m)) continue;
        double share = 1.0;
        for (const Vector3d& side : shadow.sides) {
            const Vector2d outward = side.head<2>();
            const double width_m = std::max(
                {shadow.soft_m, std::abs(outward.dot(right_m)) + std::abs(outward.dot(down_m)), 1e-6});
            share = std::min(share, 0.5 + (side.z() - outward.dot(at_m)) / width_m);
        }
        grey *= 1.0 - shadow.loss * std::max(share, 0.0);
    }
    for (const FloorSpot& spot : spots_) {
        const Vector2d off = spot.to_sigmas * (at_m - spot.centre_m);
        if (off.squaredNorm() < reach_sigmas * reach_sigmas)
            grey += spot.grey * std::exp(-off.squaredNorm() / 2);
    }
    return grey;
}

}  // namespace flownav::sim
