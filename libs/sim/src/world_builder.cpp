#include "world_builder.h"

#include <cmath>

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double wall_height_m = 2.2;

}  // namespace

Look WorldBuilder::look(Surface surface, double low_grey, double high_grey) {
    const double grey = std::round(random_.uniform(low_grey, high_grey));
    return {surface, grey, random_.bits() >> 40U};
}

std::string WorldBuilder::numbered(const std::string& name) {
    return name + "_" + std::to_string(++count_);
}

void WorldBuilder::part(const std::string& name, const Pose2& thing, const Vector3d& centre_m,
                        const Shape& shape, const Look& look) {
    Solid solid;
    solid.name = name;
    solid.shape = shape;
    const Vector2d at = transform(thing, centre_m.head<2>());
    solid.T_world_solid.translate(Vector3d(at.x(), at.y(), centre_m.z()));
    solid.T_world_solid.rotate(Eigen::AngleAxisd(thing.yaw_rad, Vector3d::UnitZ()));
    solid.look = look;
    world_.solids.push_back(solid);
}

void WorldBuilder::box(const std::string& name, const Pose2& at, const Vector2d& size_m, double height_m) {
    part(numbered(name), at, {0.0, 0.0, height_m / 2}, Box{{size_m.x(), size_m.y(), height_m}},
         look(Surface::Patterned, 80, 170));
}

void WorldBuilder::pole(const std::string& name, const Vector2d& at_m, double radius_m, double height_m,
                        double lean_rad) {
    const Pose2 at{at_m.x(), at_m.y(), random_.uniform(-M_PI, M_PI)};
    part(numbered(name), at, {0.0, 0.0, height_m / 2}, Cylinder{radius_m, height_m},
         look(Surface::Patterned, 80, 170));
    if (lean_rad != 0.0)
        world_.solids.back().T_world_solid.rotate(Eigen::AngleAxisd(lean_rad, Vector3d::UnitY()));
}

void WorldBuilder::boulder(const std::string& name, const Vector2d& at_m, double radius_m) {
    part(numbered(name), {at_m.x(), at_m.y(), 0.0}, {0.0, 0.0, radius_m / 2}, Sphere{radius_m},
         look(Surface::Patterned, 80, 170));
}

void WorldBuilder::wall(const Vector2d& a_m, const Vector2d& b_m) {
    const Vector2d along = b_m - a_m;
    const Pose2 at{a_m.x(), a_m.y(), std::atan2(along.y(), along.x())};
    part(numbered("wall"), at, {along.norm() / 2, -wall_thickness_m / 2, wall_height_m / 2},
         Box{{along.norm(), wall_thickness_m, wall_height_m}}, look(Surface::Patterned, 110, 180));
}

void WorldBuilder::chair(const Pose2& at) {
    const std::string name = numbered("chair");
    const Look wood = look(Surface::Patterned, 70, 130);
    part(name + "/seat", at, {0.0, 0.0, 0.45}, Box{{0.44, 0.44, 0.05}}, wood);
    part(name + "/back", at, {-0.205, 0.0, 0.725}, Box{{0.03, 0.44, 0.35}}, wood);
    int leg = 0;
    for (const double x : {-0.2, 0.2}) {
        for (const double y : {-0.2, 0.2}) {
            const double top_m = x < 0.0 ? 0.55 : 0.425;  // the back ones carry the back
            part(name + "/leg" + std::to_string(++leg), at, {x, y, top_m / 2}, Cylinder{0.015, top_m}, wood);
        }
    }
}

void WorldBuilder::desk(const Pose2& at) {
    const std::string name = numbered("desk");
    const Look wood = look(Surface::Patterned, 100, 170);
    part(name + "/top", at, {0.0, 0.0, 0.71}, Box{{0.7, 1.4, 0.04}}, wood);
    int leg = 0;
    for (const double x : {-0.31, 0.31}) {
        for (const double y : {-0.66, 0.66})
            part(name + "/leg" + std::to_string(++leg), at, {x, y, 0.345}, Box{{0.05, 0.05, 0.69}}, wood);
    }
}

}  // namespace flownav::sim
