#include <vector>

#include "generators.h"
#include "world_builder.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;

constexpr int columns = 3;
constexpr int rows = 2;
/// What must stay free around the middle of a door, the start and the goal.
constexpr double clear_m = 1.15;

struct Office {
    WorldBuilder& builder;
    Random& random;
    Vector2d room_m;
    std::vector<Vector2d> keep_clear_m;
    std::vector<std::pair<Vector2d, double>> furniture;  ///< middle and radius
};

/// A wall from a to b, with a door somewhere in it or without.
void inner_wall(Office& office, const Vector2d& a, const Vector2d& b, bool door) {
    if (!door) return office.builder.wall(a, b);
    const double length_m = (b - a).norm();
    const double half_door_m = office.random.uniform(1.0, 1.3) / 2;
    const double at_m = office.random.uniform(0.3 * length_m, 0.7 * length_m);
    const Vector2d along = (b - a) / length_m;
    office.builder.wall(a, a + along * (at_m - half_door_m));
    office.builder.wall(a + along * (at_m + half_door_m), b);
    office.keep_clear_m.emplace_back(a + along * at_m);
}

void outer_walls(Office& office) {
    const Vector2d size(columns * office.room_m.x(), rows * office.room_m.y());
    const std::vector<Vector2d> corners = {{0.0, 0.0}, {size.x(), 0.0}, size, {0.0, size.y()}};
    for (std::size_t i = 0; i < 4; ++i) office.builder.wall(corners[i], corners[(i + 1) % 4]);
}

void inner_walls(Office& office) {
    const double w = office.room_m.x();
    const double h = office.room_m.y();
    for (int row = 0; row < rows; ++row) {
        for (int column = 1; column < columns; ++column) {
            inner_wall(office, {column * w, row * h}, {column * w, (row + 1) * h},
                       office.random.chance(0.75));
        }
    }
    for (int column = 0; column < columns; ++column)
        inner_wall(office, {column * w, h}, {(column + 1) * w, h}, office.random.chance(0.75));
}

/// Notes the place and says yes when a thing fits there.
bool fits(Office& office, const Vector2d& at, double radius_m) {
    for (const Vector2d& point : office.keep_clear_m)
        if ((point - at).norm() < clear_m + radius_m - 0.2) return false;
    for (const auto& [middle, radius] : office.furniture)
        if ((middle - at).norm() < radius + radius_m + 0.15) return false;
    office.furniture.emplace_back(at, radius_m);
    return true;
}

/// Places against the four walls of a room, x pointing away from the wall.
Pose2 at_wall(Office& office, const Vector2d& corner, double off_m, double half_m) {
    const int side = office.random.integer(0, 3);
    const bool upright = side % 2 == 0;
    const double length_m = upright ? office.room_m.y() : office.room_m.x();
    const double along_m = office.random.uniform(half_m + 0.2, length_m - half_m - 0.2);
    switch (side) {
        case 0:
            return {corner.x() + off_m, corner.y() + along_m, 0.0};
        case 1:
            return {corner.x() + along_m, corner.y() + off_m, M_PI / 2};
        case 2:
            return {corner.x() + office.room_m.x() - off_m, corner.y() + along_m, M_PI};
        default:
            return {corner.x() + along_m, corner.y() + office.room_m.y() - off_m, -M_PI / 2};
    }
}

void furnish(Office& office, const Vector2d& corner) {
    Random& random = office.random;
    for (int i = random.integer(1, 2); i > 0; --i) {
        const Pose2 desk = at_wall(office, corner, 0.5, 0.75);
        if (!fits(office, {desk.x_m, desk.y_m}, 0.75)) continue;
        office.builder.desk(desk);
        const Vector2d seat = transform(desk, {random.uniform(0.5, 0.75), random.uniform(-0.3, 0.3)});
        bool free = true;
        for (const Vector2d& point : office.keep_clear_m) free = free && (point - seat).norm() > clear_m;
        if (free) office.builder.chair({seat.x(), seat.y(), desk.yaw_rad + M_PI + random.uniform(-0.6, 0.6)});
    }
    for (int i = random.integer(1, 2); i > 0; --i) {
        const Pose2 at = at_wall(office, corner, 0.35, 0.5);
        if (!fits(office, {at.x_m, at.y_m}, 0.45)) continue;
        if (random.chance(0.5)) {
            office.builder.box("cupboard", at, {0.4, 0.8}, random.uniform(0.8, 1.8));
        } else {
            office.builder.pole("plant", {at.x_m, at.y_m}, random.uniform(0.12, 0.22),
                                random.uniform(0.5, 1.2));
        }
    }
    const Vector2d middle =
        corner + office.room_m / 2 + Vector2d(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8));
    if (random.chance(0.5) && fits(office, middle, 0.35))
        office.builder.chair({middle.x(), middle.y(), random.uniform(-M_PI, M_PI)});
}

}  // namespace

World draw_office(Random& random) {
    World world;
    WorldBuilder builder(world, random);
    world.floor = builder.look(Surface::Carpet, 90, 150);
    Office office{builder, random, {random.uniform(4.0, 4.8), random.uniform(3.8, 4.4)}, {}, {}};
    const Vector2d start = office.room_m / 2;
    const Vector2d goal((columns - 0.5) * office.room_m.x(), (rows - 0.5) * office.room_m.y());
    office.keep_clear_m = {start, goal};
    outer_walls(office);
    inner_walls(office);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            furnish(office, {column * office.room_m.x(), row * office.room_m.y()});
    }
    world.start = {start.x(), start.y(), 0.0};
    world.goal = goal;
    return world;
}

}  // namespace flownav::sim
