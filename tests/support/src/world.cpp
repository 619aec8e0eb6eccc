#include "flownav/testing/world.h"

#include <algorithm>
#include <cmath>

#include "floor.h"

namespace flownav::testing {

const char* to_string(ThingKind kind) {
    switch (kind) {
        case ThingKind::Wall:
            return "wall";
        case ThingKind::Box:
            return "box";
        case ThingKind::LowBox:
            return "low box";
        case ThingKind::Pole:
            return "pole";
        case ThingKind::Drum:
            return "drum";
        case ThingKind::Chair:
            return "chair";
        case ThingKind::Rail:
            return "rail";
        case ThingKind::Mover:
            return "mover";
    }
    return "";
}

World at_time(const World& world, double time_s) {
    World moved = world;
    for (Primitive& p : moved.primitives) p.centre_m += time_s * p.velocity_mps;
    return moved;
}

double ground_height_m(const World& world, const Eigen::Vector2d& at_m) {
    return Floor(world.waves).height_m(at_m);
}

double distance_m(const Primitive& p, const Eigen::Vector2d& point_m) {
    const Eigen::Vector2d d = point_m - p.centre_m;
    if (p.shape == Shape::Cylinder) return std::max(0.0, d.norm() - p.half_x_m);
    const double c = std::cos(p.yaw_rad);
    const double s = std::sin(p.yaw_rad);
    const double x = std::max(0.0, std::abs(c * d.x() + s * d.y()) - p.half_x_m);
    const double y = std::max(0.0, std::abs(c * d.y() - s * d.x()) - p.half_y_m);
    return std::hypot(x, y);
}

}  // namespace flownav::testing
