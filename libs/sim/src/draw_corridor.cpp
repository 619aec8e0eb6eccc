#include <algorithm>
#include <cmath>
#include <vector>

#include "flownav/math/units.h"
#include "generators.h"
#include "world_builder.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;

constexpr double before_start_m = 1.2;
constexpr double narrowest_m = 1.0;

Vector2d direction(double angle_rad) {
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

/// A middle line with a bend at each inner point.
struct Line {
    std::vector<double> lengths_m;
    std::vector<double> headings_rad;
    std::vector<Vector2d> points_m;
};

Line draw_line(Random& random) {
    constexpr int pieces = 3;
    Line line;
    line.points_m.emplace_back(-before_start_m, 0.0);
    double heading_rad = 0.0;
    for (int i = 0; i < pieces; ++i) {
        const double bend_rad = random.uniform(30.0, 75.0) * degree_rad;
        if (i > 0) heading_rad += random.chance(0.5) ? bend_rad : -bend_rad;
        line.headings_rad.push_back(heading_rad);
        line.lengths_m.push_back(random.uniform(4.3, 5.6));
        line.points_m.emplace_back(line.points_m.back() + line.lengths_m.back() * direction(heading_rad));
    }
    return line;
}

/// The line moved to the left by `by_m`, with sharp corners.
std::vector<Vector2d> beside(const Line& line, double by_m) {
    std::vector<Vector2d> points;
    const std::size_t last = line.headings_rad.size();
    for (std::size_t i = 0; i <= last; ++i) {
        const double before_rad = line.headings_rad[i > 0 ? i - 1 : 0];
        const double after_rad = line.headings_rad[std::min(i, last - 1)];
        const double across_rad = (before_rad + after_rad) / 2 + M_PI / 2;
        points.emplace_back(line.points_m[i] +
                            direction(across_rad) * by_m / std::cos((after_rad - before_rad) / 2));
    }
    return points;
}

/// One box or pole against a wall of a straight piece.
void furnish(WorldBuilder& builder, Random& random, const Pose2& at, double width_m) {
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const double depth_m = random.uniform(0.2, std::min(0.6, width_m - narrowest_m));
    if (random.chance(0.35)) {
        const double radius_m = std::min(depth_m, 0.24) / 2;
        builder.pole("pole", transform(at, {0.0, side * (width_m / 2 - radius_m - 0.05)}), radius_m,
                     random.uniform(1.0, 2.0));
        return;
    }
    const Vector2d middle = transform(at, {0.0, side * (width_m - depth_m) / 2});
    const double along_m = random.uniform(0.25, 0.8);
    builder.box("box", {middle.x(), middle.y(), at.yaw_rad}, {along_m, depth_m}, random.uniform(0.4, 1.2));
}

}  // namespace

World draw_corridor(Random& random) {
    World world;
    WorldBuilder builder(world, random);
    world.floor = builder.look(random.chance(0.7) ? Surface::Carpet : Surface::Tiles, 90, 150);
    const double width_m = random.uniform(1.8, 2.4);
    const Line line = draw_line(random);
    const auto left = beside(line, width_m / 2);
    const auto right = beside(line, -width_m / 2);
    for (std::size_t i = 0; i + 1 < left.size(); ++i) {
        builder.wall(left[i + 1], left[i]);
        builder.wall(right[i], right[i + 1]);
    }
    builder.wall(left.front(), right.front());
    builder.wall(right.back(), left.back());
    for (std::size_t i = 0; i < line.lengths_m.size(); ++i) {
        const double from_m = i == 0 ? before_start_m + 1.8 : 1.3;
        double s_m = from_m;
        while (s_m < line.lengths_m[i] - 1.6) {
            const Vector2d at = line.points_m[i] + s_m * direction(line.headings_rad[i]);
            furnish(builder, random, {at.x(), at.y(), line.headings_rad[i]}, width_m);
            s_m += random.uniform(1.1, 1.9);
        }
    }
    world.goal = line.points_m.back() - 1.0 * direction(line.headings_rad.back());
    return world;
}

}  // namespace flownav::sim
