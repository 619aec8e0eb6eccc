#include "flownav/sim/generate_world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "flownav/sim/lidar.h"
#include "flownav/sim/passable.h"
#include "generators.h"

namespace flownav::sim {
namespace {

constexpr double half_passage_m = 0.45;
constexpr double robot_height_m = 1.0;

World draw(WorldKind kind, Random& random) {
    switch (kind) {
        case WorldKind::Corridor:
            return draw_corridor(random);
        case WorldKind::Office:
            return draw_office(random);
        case WorldKind::Hall:
            return draw_hall(random);
        case WorldKind::Forest:
            return draw_forest(random);
        case WorldKind::Stairs:
            return draw_stairs(random);
        case WorldKind::Ramp:
            return draw_ramp(random);
    }
    throw std::invalid_argument("no such kind of world");
}

/// The heading with most room ahead, up to 3 m; half a turn away from the goal counts like 1 m less.
double roomy_heading_rad(const World& world) {
    constexpr double half_view_rad = 0.3;
    LidarParams lidar;
    lidar.field_of_view_deg = 360.0;
    lidar.beams = 360;
    lidar.range_max_m = 3.0;
    const Pose2 at{world.start.x_m, world.start.y_m, 0.0};
    const VirtualScan seen = scan(world, lidar, at, 0.0);
    const double to_goal_rad = std::atan2(world.goal->y() - at.y_m, world.goal->x() - at.x_m);
    double best_rad = to_goal_rad;
    double best = -1.0;
    for (int i = 0; i < 24; ++i) {
        const double heading_rad = wrap_angle(to_goal_rad + 2.0 * M_PI * i / 24);
        double room_m = lidar.range_max_m;
        for (std::size_t k = 0; k < seen.beams.size(); ++k) {
            const double bearing_rad = seen.first_bearing_rad + static_cast<double>(k) * seen.step_rad;
            if (std::abs(wrap_angle(bearing_rad - heading_rad)) < half_view_rad)
                room_m = std::min(room_m, seen.beams[k].range_m);
        }
        const double worth = room_m - std::abs(wrap_angle(heading_rad - to_goal_rad)) / M_PI;
        if (worth > best + 1e-9) {
            best = worth;
            best_rad = heading_rad;
        }
    }
    return best_rad;
}

}  // namespace

const char* to_string(WorldKind kind) {
    switch (kind) {
        case WorldKind::Corridor:
            return "corridor";
        case WorldKind::Office:
            return "office";
        case WorldKind::Hall:
            return "hall";
        case WorldKind::Forest:
            return "forest";
        case WorldKind::Stairs:
            return "stairs";
        case WorldKind::Ramp:
            return "ramp";
    }
    return "";
}

World generate_world(WorldKind kind, std::uint64_t seed) {
    constexpr std::uint64_t attempts = 200;
    for (std::uint64_t attempt = 0; attempt < attempts; ++attempt) {
        // An odd factor spreads neighbouring seeds, attempts and kinds over all 64 bits.
        Random random((seed * 4 + static_cast<std::uint64_t>(kind)) * 0x9E3779B97F4A7C15U + attempt);
        World world = draw(kind, random);
        if (!passable(world, half_passage_m, robot_height_m)) continue;
        world.name = std::string(to_string(kind)) + "_" + std::to_string(seed);
        world.start.yaw_rad = roomy_heading_rad(world);
        return world;
    }
    throw std::runtime_error(std::string("no ") + to_string(kind) +
                             " with a way through was found for seed " + std::to_string(seed));
}

}  // namespace flownav::sim
