#include "flownav/sim/straight_scene.h"

#include <stdexcept>
#include <string>

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double wall_height_m = 2.2;
constexpr double wall_thickness_m = 0.12;
constexpr double across_m = 4.0;

Solid solid_at(const std::string& name, const Shape& shape, const Vector3d& centre_m, const Look& look) {
    Solid solid;
    solid.name = name;
    solid.shape = shape;
    solid.T_world_solid.translate(centre_m);
    solid.look = look;
    return solid;
}

GroundPiece piece_at(const std::string& name, const Vector2d& from_to_m, double height_m, const Look& look) {
    GroundPiece piece;
    piece.name = name;
    piece.T_world_ground.translate(Vector3d((from_to_m[0] + from_to_m[1]) / 2, 0.0, height_m));
    piece.size_m = {from_to_m[1] - from_to_m[0], across_m};
    piece.look = look;
    return piece;
}

void add_thing(World& world, const StraightScene& s) {
    const double x_m = s.distance_m;
    const auto box = [&](const std::string& name, const Vector3d& size_m, double left_m) {
        world.solids.push_back(
            solid_at(name, Box{size_m}, {x_m + size_m.x() / 2, left_m, size_m.z() / 2}, s.look));
    };
    switch (s.thing) {
        case AheadThing::None:
            break;
        case AheadThing::Post:
            world.solids.push_back(solid_at("post", Cylinder{s.width_m / 2, s.height_m},
                                            {x_m + s.width_m / 2, s.offset_m, s.height_m / 2}, s.look));
            break;
        case AheadThing::Box:
            box("box", {s.width_m, s.width_m, s.height_m}, s.offset_m);
            break;
        case AheadThing::DoorEdge:
            box("wall_end", {wall_thickness_m, 2.0, wall_height_m}, s.offset_m + 1.0);
            break;
        case AheadThing::WallAcross:
            box("wall", {wall_thickness_m, 6.0, wall_height_m}, s.offset_m);
            break;
        case AheadThing::StepDown:
            world.ground = {piece_at("step_1", {x_m, x_m + 0.28}, -0.17, s.floor),
                            piece_at("step_2", {x_m + 0.28, x_m + 0.56}, -0.34, s.floor),
                            piece_at("landing", {x_m + 0.56, x_m + 2.0}, -0.51, s.floor)};
            break;
        case AheadThing::KerbUp:
            world.ground = {piece_at("kerb", {x_m, x_m + 2.0}, s.height_m, s.floor)};
            break;
    }
}

void add_marks(World& world, const StraightScene& s) {
    const Look bright{Surface::Plain, s.floor.grey + 60.0, 0};
    const Look dark{Surface::Plain, s.floor.grey - 50.0, 0};
    const auto mark = [&](const std::string& name, const Vector2d& size_m, double x_m, double y_m,
                          const Look& look) {
        Solid solid = solid_at(name, Box{{size_m.x(), size_m.y(), 0.001}}, {x_m, y_m, 0.0005}, look);
        solid.solid = false;
        world.solids.push_back(solid);
    };
    mark("tape_across", {0.05, 1.5}, 1.6, 0.1, bright);
    mark("tape_along", {2.5, 0.05}, 2.2, -0.5, bright);
    mark("paper", {0.297, 0.21}, 2.5, 0.15, bright);
    mark("mat", {0.9, 0.6}, 3.3, -0.1, dark);
}

void check(const StraightScene& s) {
    if (s.distance_m > 0.0 && s.width_m > 0.0 && s.height_m > 0.0 && s.side_walls_m >= 0.0) return;
    throw std::invalid_argument(
        "straight scene: distance_m = " + std::to_string(s.distance_m) +
        ", width_m = " + std::to_string(s.width_m) + ", height_m = " + std::to_string(s.height_m) +
        ": choose above 0; side_walls_m = " + std::to_string(s.side_walls_m) + ": choose 0 or more");
}

}  // namespace

World straight_scene(const StraightScene& s) {
    check(s);
    World world;
    world.name = "straight";
    world.floor = s.floor;
    world.goal = Vector2d(s.distance_m + 2.0, 0.0);
    world.shadow_light = s.shadow_light;
    add_thing(world, s);
    if (s.marks) add_marks(world, s);
    for (const double side : {1.0, -1.0}) {
        if (s.side_walls_m == 0.0) break;
        const double y_m = side * (s.side_walls_m + wall_thickness_m / 2);
        const Look look{Surface::Plain, side > 0.0 ? 165.0 : 150.0, 0};
        world.solids.push_back(solid_at(side > 0.0 ? "left_wall" : "right_wall",
                                        Box{{s.distance_m + 6.0, wall_thickness_m, wall_height_m}},
                                        {(s.distance_m + 2.0) / 2, y_m, wall_height_m / 2}, look));
    }
    return world;
}

}  // namespace flownav::sim
