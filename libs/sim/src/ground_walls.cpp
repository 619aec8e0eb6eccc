#include <algorithm>
#include <cmath>

#include "flownav/sim/ground.h"
#include "raycast/ground.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double beside_m = 1e-6;
constexpr double shortest_m = 1e-6;

/// One side of a piece, from a to b, with the piece on its left.
struct Side {
    int piece = 0;
    Vector2d a_m, b_m;

    Vector2d at(double share) const { return a_m + share * (b_m - a_m); }
    Vector2d outward() const { return Vector2d(b_m.y() - a_m.y(), a_m.x() - b_m.x()).normalized(); }
};

/// Adds the share of a side at which two heights are the same, when there is one.
void add_equal(std::vector<double>& cuts, double at_a_m, double at_b_m) {
    if (at_a_m * at_b_m < 0.0) cuts.push_back(at_a_m / (at_a_m - at_b_m));
}

/// Shares of a side between which the ground on both of its sides is that of one piece each.
std::vector<double> cuts_of(const Ground& ground, const Side& side) {
    std::vector<double> cuts = {0.0, 1.0};
    const PlanPiece& own = ground.pieces()[static_cast<std::size_t>(side.piece)];
    add_equal(cuts, own.height_at_m(side.a_m), own.height_at_m(side.b_m));
    for (std::size_t i = 0; i < ground.pieces().size(); ++i) {
        if (static_cast<int>(i) == side.piece) continue;
        const PlanPiece& other = ground.pieces()[i];
        for (const double off_m : {-beside_m, beside_m}) {
            const auto stretch = stretch_in(other, side.a_m + off_m * side.outward(), side.b_m - side.a_m);
            if (!stretch) continue;
            for (const double share : {stretch->enter, stretch->leave})
                if (share > 0.0 && share < 1.0) cuts.push_back(share);
        }
        add_equal(cuts, own.height_at_m(side.a_m) - other.height_at_m(side.a_m),
                  own.height_at_m(side.b_m) - other.height_at_m(side.b_m));
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
}

GroundWall wall(int piece, const Vector2d& left_m, const Vector2d& right_m, const Vector2d& low_m,
                const Vector2d& high_m) {
    return {piece, Vector3d(left_m.x(), left_m.y(), low_m[0]), Vector3d(right_m.x(), right_m.y(), low_m[1]),
            high_m[0] - low_m[0], high_m[1] - low_m[1]};
}

double height_of(const Ground& ground, int piece, const Vector2d& at_m) {
    return piece == bare_floor ? 0.0 : ground.pieces()[static_cast<std::size_t>(piece)].height_at_m(at_m);
}

void add_walls(const Ground& ground, const Side& side, std::vector<GroundWall>& walls) {
    const std::vector<double> cuts = cuts_of(ground, side);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if ((cuts[i + 1] - cuts[i]) * (side.b_m - side.a_m).norm() < shortest_m) continue;
        const Vector2d middle = side.at((cuts[i] + cuts[i + 1]) / 2);
        if (ground.piece_at(middle - beside_m * side.outward()) != side.piece) continue;
        const int beyond = ground.piece_at(middle + beside_m * side.outward());
        const Vector2d a = side.at(cuts[i]);
        const Vector2d b = side.at(cuts[i + 1]);
        const Vector2d own(height_of(ground, side.piece, a), height_of(ground, side.piece, b));
        const Vector2d other(height_of(ground, beyond, a), height_of(ground, beyond, b));
        if (own.sum() > other.sum() + shortest_m) {
            walls.push_back(wall(side.piece, a, b, other, own));
        } else if (beyond == bare_floor && own.sum() < other.sum() - shortest_m) {
            walls.push_back(wall(side.piece, b, a, own.reverse(), other.reverse()));
        }
    }
}

}  // namespace

std::vector<GroundWall> ground_walls(const World& world) {
    const Ground ground(world);
    std::vector<GroundWall> walls;
    for (std::size_t i = 0; i < ground.pieces().size(); ++i) {
        const auto& corners = ground.pieces()[i].corners_m;
        for (std::size_t k = 0; k < 4; ++k)
            add_walls(ground, {static_cast<int>(i), corners[k], corners[(k + 1) % 4]}, walls);
    }
    return walls;
}

}  // namespace flownav::sim
