#include <cmath>

#include "generators.h"
#include "world_builder.h"

namespace flownav::sim {

using Eigen::Vector2d;

World draw_hall(Random& random) {
    constexpr double margin_m = 1.5;
    World world;
    WorldBuilder builder(world, random);
    world.floor = builder.look(random.chance(0.5) ? Surface::Carpet : Surface::Tiles, 90, 150);
    const Vector2d size(random.uniform(14.0, 16.0), random.uniform(9.0, 11.0));
    const std::vector<Vector2d> corners = {{0.0, 0.0}, {size.x(), 0.0}, size, {0.0, size.y()}};
    for (std::size_t i = 0; i < 4; ++i) builder.wall(corners[i], corners[(i + 1) % 4]);
    const Vector2d start(margin_m, random.uniform(0.25, 0.75) * size.y());
    const Vector2d goal(size.x() - margin_m, random.uniform(0.25, 0.75) * size.y());
    const auto is_free = [&](const Vector2d& at) {
        return (at - start).norm() > 1.6 && (at - goal).norm() > 1.3;
    };
    for (int row = 1; row <= 2; ++row) {
        for (int column = 1; column <= 3; ++column) {
            const Vector2d at(size.x() * column / 4 + random.uniform(-0.6, 0.6),
                              size.y() * row / 3 + random.uniform(-0.6, 0.6));
            if (is_free(at)) builder.pole("pillar", at, random.uniform(0.15, 0.3), 2.2);
        }
    }
    for (int i = random.integer(14, 22); i > 0; --i) {
        const Vector2d at(random.uniform(0.6, size.x() - 0.6), random.uniform(0.6, size.y() - 0.6));
        const Vector2d footprint_m(random.uniform(0.25, 0.9), random.uniform(0.25, 0.9));
        const double yaw_rad = random.uniform(-M_PI, M_PI);
        const double height_m = random.uniform(0.3, 1.3);
        if (is_free(at)) builder.box("box", {at.x(), at.y(), yaw_rad}, footprint_m, height_m);
    }
    world.start = {start.x(), start.y(), 0.0};
    world.goal = goal;
    return world;
}

World draw_forest(Random& random) {
    constexpr double length_m = 15.0;
    constexpr double width_m = 10.0;
    World world;
    WorldBuilder builder(world, random);
    world.floor = builder.look(Surface::Carpet, 80, 130);
    const Vector2d start(0.0, random.uniform(-2.0, 2.0));
    const Vector2d goal(length_m - 2.5, random.uniform(-2.0, 2.0));
    std::vector<Vector2d> taken;
    for (int i = 0; i < 90; ++i) {
        const Vector2d at(random.uniform(1.3, length_m - 3.3), random.uniform(-width_m / 2, width_m / 2));
        const double apart_m = random.uniform(0.9, 1.6);
        const double kind = random.uniform(0.0, 1.0);
        const double size_m = random.uniform(0.0, 1.0);
        const double lean_rad = random.chance(0.4) ? random.uniform(0.0, 0.08) : 0.0;
        bool free = (at - start).norm() > 1.6 && (at - goal).norm() > 1.2;
        for (const Vector2d& other : taken) free = free && (other - at).norm() > apart_m;
        if (!free) continue;
        taken.push_back(at);
        if (kind < 0.8) {
            builder.pole("trunk", at, 0.07 + 0.15 * size_m, 2.5, lean_rad);
        } else if (kind < 0.9) {
            builder.pole("stump", at, 0.12 + 0.1 * size_m, 0.25 + 0.3 * size_m);
        } else {
            builder.boulder("boulder", at, 0.25 + 0.2 * size_m);
        }
    }
    world.start = {start.x(), start.y(), 0.0};
    world.goal = goal;
    return world;
}

}  // namespace flownav::sim
