#include "contact_scene.h"

#include <algorithm>
#include <cmath>

#include "flownav/core/unicycle.h"
#include "flownav/sim/random.h"

namespace flownav::contact_bench {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double step_s = 0.001;
constexpr double weave_rad = 0.6;  ///< largest heading to either side
constexpr double alpha_radps2 = 6.0;
constexpr double beside_m = 3.0;  ///< things stand within this distance beside the path
constexpr double beyond_m = 4.0;  ///< and beyond its end

/// Size, density and distances of one kind of things.
struct Kind {
    double per_m2;
    double clear_m;  ///< between the path and the middle of a thing
    double apart_m;
};

Kind kind_of(Things things) {
    switch (things) {
        case Things::Posts:
            return {0.5, 0.48, 0.6};
        case Things::Boxes:
            return {0.35, 0.65, 0.9};
        case Things::Walls:
            return {0.12, 1.6, 2.2};
        default:
            break;
    }
    return {0.5, 0.0, 0.5};
}

std::vector<Pose2> weave(const SceneOptions& options) {
    std::vector<Pose2> path;
    Pose2 now;
    double side = 1.0;
    double turn_radps = 0.0;
    for (double t = 0.0; t < options.seconds; t += step_s) {
        path.push_back(now);
        if (side * now.yaw_rad > weave_rad) side = -side;
        const double wanted = side * options.turn_radps;
        turn_radps += std::clamp(wanted - turn_radps, -alpha_radps2 * step_s, alpha_radps2 * step_s);
        now = compose(now, along_arc(turn_radps * step_s, options.speed_mps * step_s));
    }
    return path;
}

double distance_m(const std::vector<Pose2>& path, const Vector2d& at_m) {
    double nearest_m = 1e9;
    for (std::size_t i = 0; i < path.size(); i += 20)
        nearest_m = std::min(nearest_m, (Vector2d(path[i].x_m, path[i].y_m) - at_m).norm());
    return nearest_m;
}

sim::Solid solid(const sim::Shape& shape, const Vector2d& at_m, double middle_m, double yaw_rad,
                 double grey) {
    sim::Solid s;
    s.shape = shape;
    s.T_world_solid =
        Eigen::Translation3d(at_m.x(), at_m.y(), middle_m) * Eigen::AngleAxisd(yaw_rad, Vector3d::UnitZ());
    s.look = {sim::Surface::Plain, grey, 1};
    return s;
}

/// Adds one thing; all its solids have the number `object`.
void add_thing(Things things, const Vector2d& at_m, sim::Random& random, int object, sim::World& world) {
    const double grey = std::round(random.uniform(7.0, 18.0)) * 10.0;
    const double yaw_rad = random.uniform(0.0, M_PI);
    const std::size_t first = world.solids.size();
    const auto add = [&](const sim::Shape& shape, double middle_m, double yaw, double shade) {
        world.solids.push_back(solid(shape, at_m, middle_m, yaw, shade));
    };
    if (things == Things::Posts) {
        add(sim::Cylinder{0.075, 0.5}, 0.25, 0.0, grey);
    } else if (things == Things::Boxes) {
        const double height_m = random.uniform(0.08, 0.30);
        add(sim::Box{{random.uniform(0.2, 0.4), random.uniform(0.2, 0.4), height_m}}, height_m / 2, yaw_rad,
            grey);
    } else if (things == Things::Walls) {
        const double length_m = random.uniform(0.9, 2.4);
        const double shade = std::round(random.uniform(14.0, 22.0)) * 10.0;
        add(sim::Box{{length_m, 0.1, 2.4}}, 1.2, yaw_rad, shade);
        if (random.integer(0, 2) == 0) add(sim::Box{{length_m, 0.12, 0.08}}, 0.04, yaw_rad, 70.0);
    } else {
        const bool is_tape = random.integer(0, 1) == 0;
        const Vector3d size(is_tape ? random.uniform(0.5, 2.0) : random.uniform(0.3, 1.2),
                            is_tape ? 0.05 : random.uniform(0.3, 0.8), 0.002);
        add(sim::Box{size}, 0.001, yaw_rad, std::round(random.uniform(4.0, 22.0)) * 10.0);
    }
    for (std::size_t i = first; i < world.solids.size(); ++i) {
        world.solids[i].object = object;
        world.solids[i].name = to_string(things) + std::to_string(object);
    }
}

/// Adds the one thing straight ahead, its near face at `ahead_m`, a few centimetres beside the way.
void add_ahead(const SceneOptions& options, sim::Random& random, sim::World& world) {
    const double grey = std::round(random.uniform(6.0, 20.0)) * 10.0;
    const double side_m = random.uniform(-0.15, 0.15);
    const auto add = [&](const sim::Shape& shape, const Vector2d& at_m, double middle_m, double shade) {
        world.solids.push_back(solid(shape, at_m, middle_m, 0.0, shade));
        world.solids.back().object = 1;
        world.solids.back().name = to_string(options.things);
    };
    const double x = options.ahead_m;
    if (options.things == Things::PostAhead) {
        add(sim::Cylinder{0.075, 0.5}, {x + 0.075, side_m}, 0.25, grey);
    } else if (options.things == Things::BoxAhead) {
        add(sim::Box{{0.3, 0.3, 0.24}}, {x + 0.15, side_m}, 0.12, grey);
    } else if (options.things == Things::LowBoxAhead) {
        add(sim::Box{{0.3, 0.3, 0.12}}, {x + 0.15, side_m}, 0.06, grey);
    } else if (options.things == Things::EndAhead) {
        add(sim::Box{{0.1, 2.0, 2.4}}, {x + 0.05, side_m + (side_m > 0.0 ? 1.0 : -1.0)}, 1.2, grey);
    } else if (options.things == Things::WallAhead) {
        add(sim::Box{{0.1, 8.0, 2.4}}, {x + 0.05, side_m}, 1.2, grey);
    } else {
        for (int i = 0; i < 6; ++i) {
            const double at_x = random.uniform(0.8, x);
            const Vector3d size(random.uniform(0.05, 0.6), random.uniform(0.2, 1.5), 0.002);
            add(sim::Box{size}, {at_x, random.uniform(-0.4, 0.4)}, 0.001,
                std::round(random.uniform(4.0, 22.0)) * 10.0);
        }
    }
}

sim::World world_of(const SceneOptions& options, const std::vector<Pose2>& path) {
    sim::World world;
    world.floor = {options.floor, 128.0, options.seed};
    if (is_ahead(options.things)) {
        sim::Random random(options.seed * 97 + static_cast<std::uint64_t>(options.things));
        add_ahead(options, random, world);
        return world;
    }
    Vector2d low(1e9, 1e9);
    Vector2d high(-1e9, -1e9);
    for (const Pose2& p : path) {
        low = low.cwiseMin(Vector2d(p.x_m, p.y_m));
        high = high.cwiseMax(Vector2d(p.x_m, p.y_m));
    }
    low.y() -= beside_m;
    high += Vector2d(beyond_m, beside_m);
    const Kind kind = kind_of(options.things);
    sim::Random random(options.seed * 31 + static_cast<std::uint64_t>(options.things));
    std::vector<Vector2d> places;
    const int trials = static_cast<int>((high - low).prod() * kind.per_m2);
    for (int i = 0; i < trials; ++i) {
        const Vector2d at_m(random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()));
        const bool crowded = std::any_of(places.begin(), places.end(),
                                         [&](const Vector2d& p) { return (p - at_m).norm() < kind.apart_m; });
        if (crowded || distance_m(path, at_m) < kind.clear_m) continue;
        places.push_back(at_m);
        add_thing(options.things, at_m, random, static_cast<int>(places.size()), world);
    }
    return world;
}

}  // namespace

bool is_ahead(Things things) {
    return things >= Things::PostAhead;
}

const char* to_string(Things things) {
    switch (things) {
        case Things::Posts:
            return "posts";
        case Things::Boxes:
            return "boxes";
        case Things::Walls:
            return "walls";
        case Things::Mats:
            return "mats";
        case Things::PostAhead:
            return "post ahead";
        case Things::BoxAhead:
            return "box ahead";
        case Things::LowBoxAhead:
            return "low box ahead";
        case Things::EndAhead:
            return "wall end ahead";
        case Things::WallAhead:
            return "wall ahead";
        case Things::MatsAhead:
            return "mats ahead";
    }
    return "";
}

RecordedScene record(const SceneOptions& options, const sim::CameraSimParams& camera) {
    RecordedScene scene;
    scene.options = options;
    const std::vector<Pose2> path = weave(options);  // straight without a turn rate
    scene.world = world_of(options, path);
    sim::CameraSimulator simulator(scene.world, camera);
    const int images = static_cast<int>(options.seconds * camera.rate_hz);
    for (int i = 0; i < images; ++i) {
        const double time_s = i / camera.rate_hz;
        const auto moment = static_cast<std::size_t>(std::lround(time_s / step_s));
        if (moment >= path.size()) break;
        scene.poses.push_back(path[moment]);
        scene.fields.push_back(simulator.take(i, path[moment], time_s));
    }
    return scene;
}

}  // namespace flownav::contact_bench
