#include "furniture.h"

#include <cmath>

#include "flownav/sim/surface_texture.h"

namespace flownav::testing {
namespace {

using Eigen::Vector2d;
using sim::HashRandom;

Part box(const Vector2d& at_m, double z_low_m, double z_high_m, double half_x_m, double half_y_m,
         Surface surface, double shade) {
    return {{UprightShape::Box, at_m, z_low_m, z_high_m, half_x_m, half_y_m, 0.0}, surface, shade};
}

Part cylinder(const Vector2d& at_m, double radius_m, double z_high_m, Surface surface, double shade) {
    return {{UprightShape::Cylinder, at_m, 0.0, z_high_m, radius_m, 0.0, 0.0}, surface, shade};
}

/// To the five decimals of the tables: the rendered objects are exactly those of the tables.
double rounded(double value) {
    return std::round(value * 1e5) / 1e5;
}

Thing of_kind(Thing thing, ThingKind kind) {
    for (Part& part : thing) part.kind = kind;
    return thing;
}

}  // namespace

Thing make_chair(HashRandom& random) {
    const double half = 0.20;
    Thing chair;
    for (const double x : {-half, half}) {
        for (const double y : {-half, half})
            chair.push_back(cylinder({x, y}, 0.017, 0.43, Surface::Faint, random.uniform(0.5, 0.7)));
    }
    chair.push_back(box({0, 0}, 0.43, 0.47, 0.22, 0.22, Surface::Patterned, 0.8));
    chair.push_back(box({-0.21, 0}, 0.62, 0.92, 0.015, 0.22, Surface::Patterned, 0.8));
    return of_kind(chair, ThingKind::Chair);
}

Thing make_drum(HashRandom& random) {
    return of_kind({cylinder({0, 0}, 0.13, 0.60, Surface::Patterned, random.uniform(0.9, 1.1))},
                   ThingKind::Drum);
}

Thing make_pole(HashRandom& random) {
    return of_kind({cylinder({0, 0}, 0.025, 1.10, Surface::Patterned, random.uniform(0.6, 0.9))},
                   ThingKind::Pole);
}

Thing make_low_box(HashRandom& random) {
    return of_kind({box({0, 0}, 0.0, 0.15, 0.20, 0.15, Surface::Patterned, random.uniform(0.8, 1.0))},
                   ThingKind::LowBox);
}

Thing make_box(HashRandom& random) {
    const double height_m = random.uniform(0.45, 0.85);
    const Surface surface = random.uniform(0, 1) < 0.7 ? Surface::Patterned : Surface::Faint;
    return {box({0, 0}, 0.0, height_m, 0.20, 0.20, surface, random.uniform(0.7, 1.1))};
}

Thing make_rail(double length_m, HashRandom& random) {
    const double half_m = 0.5 * length_m;
    Thing rail;
    for (const double x : {-half_m, 0.0, half_m})
        rail.push_back(cylinder({x, 0}, 0.02, 0.90, Surface::Patterned, random.uniform(0.6, 0.8)));
    for (const double z : {0.45, 0.87})
        rail.push_back(box({0, 0}, z, z + 0.04, half_m, 0.02, Surface::Patterned, random.uniform(0.6, 0.8)));
    return of_kind(rail, ThingKind::Rail);
}

Thing make_wall(const Vector2d& from_m, const Vector2d& to_m) {
    const Vector2d along = to_m - from_m;
    const Vector2d middle = 0.5 * (from_m + to_m);
    Thing wall{box(middle, 0.0, 2.5, 0.5 * along.norm(), 0.05, Surface::Wall, 1.0),
               box(middle, 0.0, 0.1, 0.5 * along.norm() + 0.008, 0.058, Surface::Patterned, 0.45)};
    for (Part& part : wall) part.shape.yaw_rad = std::atan2(along.y(), along.x());
    return of_kind(wall, ThingKind::Wall);
}

std::vector<Solid> placed(Thing thing, const Vector2d& at_m, double yaw_rad, int object, HashRandom& random) {
    const double c = std::cos(yaw_rad);
    const double s = std::sin(yaw_rad);
    std::vector<Solid> solids;
    for (Part& part : thing) {
        Upright& u = part.shape;
        const Vector2d local = u.centre_m;
        u.centre_m = {rounded(at_m.x() + c * local.x() - s * local.y()),
                      rounded(at_m.y() + s * local.x() + c * local.y())};
        u.yaw_rad = u.shape == UprightShape::Cylinder ? 0.0 : u.yaw_rad + yaw_rad;
        u.z_high_m = rounded(u.z_high_m);
        u.half_x_m = rounded(u.half_x_m);
        u.half_y_m = rounded(u.half_y_m);
        const double grey = rounded(part.shade) * sim::usual_grey(part.surface);
        Solid solid = solid_of(u, {part.surface, grey, random.bits()});
        solid.name = to_string(part.kind);
        solid.kind = part.kind;
        solid.object = object;
        solids.push_back(solid);
    }
    return solids;
}

}  // namespace flownav::testing
