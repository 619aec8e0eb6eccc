#include <cmath>
#include <string>
#include <vector>

#include "generators.h"
#include "world_builder.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double riser_m = 0.17;
constexpr double tread_m = 0.28;

/// Adds a level piece of ground in the frame of a thing.
void level_piece(World& world, const std::string& name, const Pose2& thing, const Vector2d& middle_m,
                 const Vector2d& size_m, double height_m, const Look& look) {
    GroundPiece piece;
    piece.name = name;
    const Vector2d at = transform(thing, middle_m);
    piece.T_world_ground.translate(Vector3d(at.x(), at.y(), height_m));
    piece.T_world_ground.rotate(Eigen::AngleAxisd(thing.yaw_rad, Vector3d::UnitZ()));
    piece.size_m = size_m;
    piece.look = look;
    world.ground.push_back(piece);
}

/// Stairs that lead down from the origin of `top` along its x, and a landing below them. Returns their
/// length.
double stairs_down(World& world, const Pose2& top, double width_m, int steps, double landing_m,
                   const Look& look) {
    for (int i = 0; i < steps; ++i)
        level_piece(world, "step_" + std::to_string(i + 1), top, {(i + 0.5) * tread_m, 0.0},
                    {tread_m, width_m}, -(i + 1) * riser_m, look);
    level_piece(world, "landing", top, {steps * tread_m + landing_m / 2, 0.0}, {landing_m, width_m},
                -(steps + 1) * riser_m, look);
    return steps * tread_m + landing_m;
}

void room(WorldBuilder& builder, const Vector2d& low, const Vector2d& high) {
    const std::vector<Vector2d> corners = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
    for (std::size_t i = 0; i < 4; ++i) builder.wall(corners[i], corners[(i + 1) % 4]);
}

Surface floor_of(Random& random) {
    const double kind = random.uniform(0.0, 1.0);
    return kind < 0.4 ? Surface::Carpet : kind < 0.7 ? Surface::Tiles : Surface::Lino;
}

/// A room with the open well of a stair between start and goal.
void draw_stairwell(World& world, WorldBuilder& builder, Random& random) {
    const Vector2d size(10.5, random.uniform(5.5, 7.0));
    room(builder, {0.0, 0.0}, size);
    const int steps = random.integer(3, 5);
    const double landing_m = random.uniform(0.6, 0.9);
    const double length_m = steps * tread_m + landing_m;
    const double yaw_rad = random.integer(0, 3) * M_PI / 2;
    const Vector2d middle(random.uniform(4.6, 6.0), random.uniform(0.35, 0.65) * size.y());
    const Vector2d top = middle - length_m / 2 * Vector2d(std::cos(yaw_rad), std::sin(yaw_rad));
    stairs_down(world, {top.x(), top.y(), yaw_rad}, random.uniform(1.1, 1.8), steps, landing_m,
                builder.look(world.floor.surface, 90, 150));
    for (int i = random.integer(1, 3); i > 0; --i) {
        const Vector2d at(random.uniform(2.5, 8.0), random.chance(0.5) ? 0.35 : size.y() - 0.35);
        builder.box("box", {at.x(), at.y(), 0.0}, {random.uniform(0.3, 0.7), random.uniform(0.3, 0.5)},
                    random.uniform(0.3, 1.2));
    }
    world.start = {1.2, random.uniform(0.35, 0.65) * size.y(), 0.0};
    world.goal = Vector2d(size.x() - 1.2, random.uniform(0.35, 0.65) * size.y());
}

/// A wide corridor; along one wall the ground is lower or higher by a kerb.
void draw_kerb(World& world, WorldBuilder& builder, Random& random) {
    constexpr double length_m = 12.0;
    const double own_m = random.uniform(1.9, 2.6);
    const double beside_m = random.uniform(1.0, 1.8);
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const double height_m = random.chance(0.7) ? -random.uniform(0.06, 0.20) : random.uniform(0.05, 0.12);
    const double edge_m = side * own_m / 2;
    const double far_m = edge_m + side * beside_m;
    room(builder, {-1.2, std::min(far_m, -edge_m)}, {length_m - 1.2, std::max(far_m, -edge_m)});
    level_piece(world, "kerb", {}, {length_m / 2 - 1.2, (edge_m + far_m) / 2}, {length_m, beside_m}, height_m,
                builder.look(world.floor.surface, 90, 150));
    for (double x_m = 2.6; x_m < length_m - 4.0; x_m += random.uniform(2.0, 3.0)) {
        const double depth_m = random.uniform(0.2, own_m - 1.3);
        builder.box("box", {x_m, -edge_m + side * depth_m / 2, 0.0}, {random.uniform(0.3, 0.8), depth_m},
                    random.uniform(0.3, 1.2));
    }
    world.start = {};
    world.goal = Vector2d(length_m - 2.4, 0.0);
}

/// A corridor that ends in a stair down; the way goes off to one side before it.
void draw_stair_ahead(World& world, WorldBuilder& builder, Random& random) {
    const double half_m = random.uniform(1.0, 1.3);
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const double branch_m = random.uniform(4.2, 5.2);
    const double branch_half_m = random.uniform(0.9, 1.1);
    const double edge_m = branch_m + branch_half_m + random.uniform(0.3, 1.0);
    const int steps = random.integer(4, 6);
    const double end_m = edge_m + stairs_down(world, {edge_m, 0.0, 0.0}, 2 * half_m, steps, 0.8,
                                              builder.look(world.floor.surface, 90, 150));
    const double far_m = side * (half_m + random.uniform(7.0, 8.0));
    const double behind_m = side * (half_m + WorldBuilder::wall_thickness_m);  // where walls do not overlap
    const auto wall = [&](const Vector2d& a, const Vector2d& b) {
        builder.wall(side > 0 ? a : b, side > 0 ? b : a);
    };
    wall({-1.2, -side * half_m}, {end_m, -side * half_m});
    wall({end_m, -side * half_m}, {end_m, side * half_m});
    wall({end_m, side * half_m}, {branch_m + branch_half_m, side * half_m});
    wall({branch_m + branch_half_m, behind_m}, {branch_m + branch_half_m, far_m});
    wall({branch_m + branch_half_m, far_m}, {branch_m - branch_half_m, far_m});
    wall({branch_m - branch_half_m, far_m}, {branch_m - branch_half_m, behind_m});
    wall({branch_m - branch_half_m, side * half_m}, {-1.2, side * half_m});
    wall({-1.2, side * half_m}, {-1.2, -side * half_m});
    world.start = {};
    world.goal = Vector2d(branch_m, far_m - side * 1.0);
}

}  // namespace

World draw_stairs(Random& random) {
    World world;
    WorldBuilder builder(world, random);
    world.floor = builder.look(floor_of(random), 90, 150);
    switch (random.integer(0, 2)) {
        case 0:
            draw_stairwell(world, builder, random);
            break;
        case 1:
            draw_kerb(world, builder, random);
            break;
        default:
            draw_stair_ahead(world, builder, random);
    }
    return world;
}

}  // namespace flownav::sim
