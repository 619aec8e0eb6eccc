#include "layout.h"

#include <algorithm>
#include <cmath>

#include "flownav/sim/surface_texture.h"
#include "furniture.h"

namespace flownav::testing {
namespace {

using Eigen::Vector2d;
using sim::HashRandom;
using sim::mix;
using Solids = std::vector<Solid>;

constexpr double free_beside_path_m = 0.5;
constexpr int first_rail = 60;  // their object numbers
constexpr int first_near_box = 70;
constexpr double near_box_first_m = 1.0;  // along the way
constexpr double near_box_every_m = 0.6;
constexpr double ahead_m = 3.0;  ///< objects stand along this much more than the path

/// The path, and straight on from its end.
std::vector<Pose2> extended(const std::vector<Pose2>& path) {
    std::vector<Pose2> longer = path;
    constexpr int steps = 60;
    for (int i = 1; i <= steps; ++i) longer.push_back(compose(path.back(), {i * ahead_m / steps, 0.0, 0.0}));
    return longer;
}

bool clear_of(const std::vector<Pose2>& way, const Solids& thing) {
    return std::all_of(way.begin(), way.end(), [&](const Pose2& pose) {
        return std::all_of(thing.begin(), thing.end(), [&](const Solid& solid) {
            return distance_m(solid, Vector2d(pose.x_m, pose.y_m)) >= free_beside_path_m;
        });
    });
}

bool apart_from(const World& world, const Vector2d& at_m) {
    return std::all_of(world.solids.begin(), world.solids.end(), [&](const Solid& solid) {
        return distance_m(solid, at_m) > (solid.object == wall_object ? 0.35 : 0.45);
    });
}

void add(World& world, const Solids& thing) {
    world.solids.insert(world.solids.end(), thing.begin(), thing.end());
}

Thing make_thing(int kind, HashRandom& random) {
    switch (kind % 6) {
        case 0:
            return make_chair(random);
        case 1:
            return make_drum(random);
        case 2:
            return make_pole(random);
        case 3:
            return make_low_box(random);
        default:
            return make_box(random);
    }
}

Thing make_corridor_thing(int kind, HashRandom& random) {
    return kind % 3 == 1 ? make_pole(random) : make_box(random);
}

/// Railings along the way, on either side.
void add_rails(World& world, const std::vector<Pose2>& way) {
    HashRandom random(mix(world.floor.seed, 17));
    int object = first_rail;
    for (const double share : {0.30, 0.62}) {
        const Pose2& beside = way[static_cast<std::size_t>(share * static_cast<double>(way.size()))];
        for (double side_m = object % 2 == 0 ? 0.95 : -0.95; std::abs(side_m) < 2.0; side_m *= 1.1) {
            const Solids rail = placed(make_rail(1.6, random), transform(beside, Vector2d(0.5, side_m)),
                                       beside.yaw_rad, object, random);
            if (!clear_of(way, rail)) continue;
            add(world, rail);
            break;
        }
        ++object;
    }
}

/// A railing and a chair, which the loop leads around.
void add_island(World& world) {
    HashRandom random(mix(world.floor.seed, 29));
    add(world, placed(make_rail(2.2, random), {1.3, 1.75}, 0.0, first_rail, random));
    add(world, placed(make_chair(random), {3.3, 1.75}, 0.6, first_rail + 1, random));
}

/// Boxes beside the wheels, so near that they stand in the part of the image that shows the ground right
/// before the robot.
void add_near_boxes(World& world, const std::vector<Pose2>& way) {
    HashRandom random(mix(world.floor.seed, 19));
    int object = first_near_box;
    double since_m = -near_box_first_m;
    for (std::size_t i = 1; i < way.size(); ++i) {
        since_m += std::hypot(way[i].x_m - way[i - 1].x_m, way[i].y_m - way[i - 1].y_m);
        if (since_m < 0.0) continue;
        since_m -= near_box_every_m;
        Thing box = object % 2 == 0 ? make_low_box(random) : make_box(random);
        for (Part& part : box) part.shape.half_x_m = part.shape.half_y_m = 0.12;
        const double side_m = object % 2 == 0 ? 0.40 : -0.40;
        add(world, placed(box, transform(way[i], Vector2d(0.0, side_m)), way[i].yaw_rad, object, random));
        ++object;
    }
}

/// Objects to the left and right of the way, at most `reach_m` from it.
void add_things(World& world, const SceneOptions& options, const std::vector<Pose2>& way, int wanted,
                double reach_m, HashRandom& random) {
    int object = 1;
    for (int attempt = 0; attempt < 60 * wanted && object <= wanted; ++attempt) {
        const auto along = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(way.size())));
        const double beside_m = random.uniform(0.6, reach_m);
        // The island of the loop has its things already.
        const bool right = options.kind == SceneKind::Loop || random.uniform(0, 1) < 0.5;
        const double side_m = right ? -beside_m : beside_m;
        const Vector2d at_m = transform(way[along], Vector2d(0.5, side_m));
        const Thing raw = options.kind == SceneKind::Corridor ? make_corridor_thing(object, random)
                                                              : make_thing(object, random);
        const Solids thing = placed(raw, at_m, random.uniform(-M_PI, M_PI), object, random);
        if (!clear_of(way, thing) || !apart_from(world, at_m)) continue;
        add(world, thing);
        ++object;
    }
}

void add_room(World& world, const std::vector<Pose2>& way, double margin_x_m, double margin_y_m,
              HashRandom& random) {
    const auto by_x = std::minmax_element(way.begin(), way.end(),
                                          [](const Pose2& a, const Pose2& b) { return a.x_m < b.x_m; });
    const auto by_y = std::minmax_element(way.begin(), way.end(),
                                          [](const Pose2& a, const Pose2& b) { return a.y_m < b.y_m; });
    const double west = by_x.first->x_m - 2.0;
    const double east = by_x.second->x_m + margin_x_m;
    const double south = by_y.first->y_m - margin_y_m;
    const double north = by_y.second->y_m + margin_y_m;
    const std::vector<Vector2d> corners = {{west, south}, {east, south}, {east, north}, {west, north}};
    for (std::size_t i = 0; i < 4; ++i)
        add(world, placed(make_wall(corners[i], corners[(i + 1) % 4]), {0, 0}, 0.0, wall_object, random));
}

/// A large box that keeps ahead of the robot and crosses its way from the left.
Solids make_mover(const SceneOptions& options, HashRandom& random) {
    Part box;
    box.shape.half_x_m = 0.25;
    box.shape.half_y_m = 0.5 * options.mover.width_m;
    box.shape.z_high_m = 1.7;
    box.kind = ThingKind::Mover;
    Solids mover = placed({box}, {options.mover.ahead_m, options.mover.start_left_m}, 0.0, 50, random);
    const double end_s = options.images / options.rate_hz + 1.0;
    set_velocity(mover.front(), {options.speed_mps, -options.mover.speed_mps}, end_s);
    return mover;
}

}  // namespace

World make_world(const SceneOptions& options, const std::vector<Pose2>& path) {
    HashRandom random(mix(options.seed, 7));
    World world;
    world.floor = {options.floor, sim::usual_grey(options.floor), random.bits()};
    world.sky_grey = 60.0;
    world.shading = 0.28;
    world.waves = {options.floor_waves_m, mix(options.seed, 23)};
    if (options.kind == SceneKind::Free) return world;
    const std::vector<Pose2> way = extended(path);
    const bool corridor = options.kind == SceneKind::Corridor;
    const double length_m = static_cast<double>(path.size()) / options.rate_hz * options.speed_mps + ahead_m;
    World walls;
    add_room(walls, way, corridor ? 1.0 : 2.0, corridor ? 1.25 : 2.6, random);
    const double reach_m = corridor ? 1.0 : 2.1;
    const int wanted = static_cast<int>(std::lround(length_m * (corridor ? 1.6 : 1.8)));
    if (options.kind == SceneKind::Loop) add_island(world);
    if (options.rails) add_rails(world, way);
    if (options.near_boxes) add_near_boxes(world, way);
    add_things(world, options, way, wanted, reach_m, random);
    add(world, walls.solids);
    if (options.kind == SceneKind::Mover) add(world, make_mover(options, random));
    return world;
}

}  // namespace flownav::testing
