#include <algorithm>
#include <cmath>
#include <string>

#include "flownav/math/units.h"
#include "generators.h"
#include "world_builder.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double steepest_rad = 8.0 * degree_rad;

/// Adds a piece of ground across the corridor whose middle line leads from a to b, x and height.
void slab(World& world, const std::string& name, const Vector2d& a_m, const Vector2d& b_m, double width_m,
          const Look& look) {
    const Vector2d along = b_m - a_m;
    GroundPiece piece;
    piece.name = name;
    piece.T_world_ground.translate(Vector3d((a_m.x() + b_m.x()) / 2, 0.0, (a_m.y() + b_m.y()) / 2));
    piece.T_world_ground.rotate(Eigen::AngleAxisd(-std::atan2(along.y(), along.x()), Vector3d::UnitY()));
    piece.size_m = {along.norm(), width_m};
    piece.look = look;
    world.ground.push_back(piece);
}

}  // namespace

World draw_ramp(Random& random) {
    constexpr double behind_m = 1.2;
    World world;
    WorldBuilder builder(world, random);
    const Surface surface = random.chance(0.6) ? Surface::Carpet : Surface::Tiles;
    world.floor = builder.look(surface, 90, 150);
    const double width_m = random.uniform(2.2, 3.0);
    const double covered_m = width_m + 0.05;  // into the walls
    const double rise_m = random.uniform(1.5, 2.6) * std::sin(random.uniform(3.0 * degree_rad, steepest_rad));
    const double down_rad = random.uniform(std::asin(rise_m / 3.2), steepest_rad);
    const double up_rad = random.uniform(std::asin(rise_m / 3.2), steepest_rad);
    const double foot_m = random.uniform(2.2, 3.0);
    const double top_m = foot_m + rise_m / std::tan(up_rad);
    const double edge_m = top_m + random.uniform(1.6, 2.4);
    const double end_m = edge_m + rise_m / std::tan(down_rad);
    if (random.chance(0.5))
        slab(world, "threshold", {1.2, 0.02}, {1.3, 0.02}, covered_m, builder.look(Surface::Plain, 60, 180));
    const Look look = builder.look(surface, 90, 150);
    slab(world, "ramp_up", {foot_m, 0.0}, {top_m, rise_m}, covered_m, look);
    slab(world, "platform", {top_m, rise_m}, {edge_m, rise_m}, covered_m, look);
    slab(world, "ramp_down", {edge_m, rise_m}, {end_m, 0.0}, covered_m, look);
    const double last_m = std::max(end_m + 2.6, 9.2 + behind_m);
    const double half_m = width_m / 2;
    builder.wall({-behind_m, -half_m}, {last_m, -half_m});
    builder.wall({last_m, -half_m}, {last_m, half_m});
    builder.wall({last_m, half_m}, {-behind_m, half_m});
    builder.wall({-behind_m, half_m}, {-behind_m, -half_m});
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    builder.box("box", {end_m + 0.6, side * (half_m - 0.2), 0.0}, {0.4, 0.4}, random.uniform(0.4, 1.0));
    world.start = {};
    world.goal = Vector2d(last_m - 1.0, 0.0);
    return world;
}

}  // namespace flownav::sim
