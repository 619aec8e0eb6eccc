#include "ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flownav/core/plane_geometry.h"
#include "flownav/sim/ground.h"

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double nearest_t = 1e-4;
constexpr double same_t = 1e-9;
constexpr double seam_t = 1e-7;  ///< a top that is met this much before its side counts, too
constexpr double endless = std::numeric_limits<double>::infinity();

void update(std::vector<int>& cover, int piece, bool enters) {
    if (enters) {
        cover.push_back(piece);
    } else {
        cover.erase(std::remove(cover.begin(), cover.end(), piece), cover.end());
    }
}

}  // namespace

PlanPiece plan_of(const GroundPiece& piece) {
    PlanPiece plan;
    const Vector2d half = piece.size_m / 2;
    const std::array<Vector2d, 4> local = {-half, Vector2d(half.x(), -half.y()), half,
                                           Vector2d(-half.x(), half.y())};
    for (std::size_t i = 0; i < 4; ++i)
        plan.corners_m[i] = (piece.T_world_ground * Vector3d(local[i].x(), local[i].y(), 0.0)).head<2>();
    const Vector3d normal = piece.T_world_ground.linear().col(2);
    plan.slope = -normal.head<2>() / normal.z();
    const Vector3d& at = piece.T_world_ground.translation();
    plan.height_m = at.z() - plan.slope.dot(at.head<2>());
    return plan;
}

std::optional<PieceStretch> stretch_in(const PlanPiece& piece, const Vector2d& from_m,
                                       const Vector2d& along) {
    PieceStretch stretch{-endless, endless, 0, 0};
    for (int side = 0; side < 4; ++side) {
        const Vector2d& a = piece.corners_m[static_cast<std::size_t>(side)];
        const Vector2d edge = piece.corners_m[static_cast<std::size_t>((side + 1) % 4)] - a;
        const double inside = cross(edge, from_m - a);  // > 0 on the left of the side
        const double gain = cross(edge, along);
        if (gain == 0.0) {
            if (inside <= 0.0) return std::nullopt;
            continue;
        }
        const double t = -inside / gain;
        if (gain > 0.0 && t > stretch.enter) {
            stretch.enter = t;
            stretch.enter_side = side;
        } else if (gain < 0.0 && t < stretch.leave) {
            stretch.leave = t;
            stretch.leave_side = side;
        }
    }
    if (stretch.enter >= stretch.leave) return std::nullopt;
    return stretch;
}

Ground::Ground(const World& world) : floor_(world.waves) {
    for (const GroundPiece& piece : world.ground) pieces_.push_back(plan_of(piece));
}

double Ground::height_m(const Cover& cover, const Vector2d& at_m) const {
    if (cover.empty()) return floor_.height_m(at_m);
    double highest_m = -endless;
    for (const int i : cover)
        highest_m = std::max(highest_m, pieces_[static_cast<std::size_t>(i)].height_at_m(at_m));
    return highest_m;
}

int Ground::piece_at(const Vector2d& at_m) const {
    int highest = bare_floor;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        bool inside = true;
        for (std::size_t k = 0; k < 4; ++k) {
            const Vector2d& a = pieces_[i].corners_m[k];
            inside = inside && cross(pieces_[i].corners_m[(k + 1) % 4] - a, at_m - a) >= 0.0;
        }
        if (!inside) continue;
        if (highest == bare_floor ||
            pieces_[i].height_at_m(at_m) > pieces_[static_cast<std::size_t>(highest)].height_at_m(at_m))
            highest = static_cast<int>(i);
    }
    return highest;
}

double Ground::height_m(const Vector2d& at_m) const {
    const int piece = piece_at(at_m);
    return piece == bare_floor ? floor_.height_m(at_m)
                               : pieces_[static_cast<std::size_t>(piece)].height_at_m(at_m);
}

/// Sides of pieces that a line crosses beyond `first`, in order, and the pieces that cover its place there.
std::vector<Ground::Crossing> Ground::crossings(const Vector2d& from_m, const Vector2d& along, double first,
                                                Cover& cover) const {
    std::vector<Crossing> found;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const auto stretch = stretch_in(pieces_[i], from_m, along);
        if (!stretch || stretch->leave <= first) continue;
        const int piece = static_cast<int>(i);
        if (stretch->enter > first) {
            found.push_back({stretch->enter, piece, stretch->enter_side, true});
        } else {
            cover.push_back(piece);
        }
        if (stretch->leave < endless) found.push_back({stretch->leave, piece, stretch->leave_side, false});
    }
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    return found;
}

double Ground::steps_m(const Vector2d& from_m, const Vector2d& to_m) const {
    if (pieces_.empty() || from_m == to_m) return 0.0;
    Cover cover;
    double sum_m = 0.0;
    for (const Crossing& crossing : crossings(from_m, to_m - from_m, 0.0, cover)) {
        if (crossing.t >= 1.0) break;
        const Vector2d at_m = from_m + crossing.t * (to_m - from_m);
        const double before_m = height_m(cover, at_m);
        update(cover, crossing.piece, crossing.enters);
        sum_m += height_m(cover, at_m) - before_m;
    }
    return sum_m;
}

GroundHit Ground::meet_top(const Cover& cover, const Ray& ray, double from_t, double to_t) const {
    GroundHit hit;
    if (cover.empty()) {
        if (ray.direction.z() >= -1e-9) return hit;
        const double t = floor_.meet(ray);
        if (t >= from_t && t < to_t) hit.t = t;
        return hit;
    }
    for (const int i : cover) {
        const PlanPiece& piece = pieces_[static_cast<std::size_t>(i)];
        const double above_m = ray.origin_m.z() - piece.height_at_m(ray.origin_m.head<2>());
        const double sinking = ray.direction.z() - piece.slope.dot(ray.direction.head<2>());
        if (sinking >= -1e-12) continue;
        const double t = -above_m / sinking;
        if (t < from_t - seam_t || t >= to_t || t >= hit.t) continue;
        hit.t = t;
        hit.piece = i;
    }
    return hit;
}

/// The wall at a place where the ray runs into higher ground, from the sides that it crosses there. It
/// belongs to the piece that begins, or to the hole that ends.
GroundHit Ground::wall_of(const Cover& cover, const Vector2d& at_m, const Crossing* first,
                          const Crossing* last) const {
    const Crossing* wall = first;
    for (const Crossing* c = first; c != last; ++c) {
        const bool highest = c->enters && pieces_[static_cast<std::size_t>(c->piece)].height_at_m(at_m) >=
                                              height_m(cover, at_m);
        if (highest) wall = c;
    }
    return {first->t, wall->piece, wall->side, !wall->enters};
}

GroundHit Ground::meet(const Ray& ray) const {
    Cover cover;
    const Vector2d from_m = ray.origin_m.head<2>();
    const Vector2d along = ray.direction.head<2>();
    const std::vector<Crossing> all = crossings(from_m, along, nearest_t, cover);
    double from_t = nearest_t;
    for (std::size_t i = 0; i < all.size();) {
        const GroundHit top = meet_top(cover, ray, from_t, all[i].t);
        if (std::isfinite(top.t)) return top;
        std::size_t next = i;
        for (; next < all.size() && all[next].t <= all[i].t + same_t; ++next)
            update(cover, all[next].piece, all[next].enters);
        const Vector2d at_m = from_m + all[i].t * along;
        if (ray.origin_m.z() + all[i].t * ray.direction.z() < height_m(cover, at_m))
            return wall_of(cover, at_m, &all[i], &all[i] + (next - i));
        from_t = all[i].t;
        i = next;
    }
    return meet_top(cover, ray, from_t, endless);
}

double ground_height_m(const World& world, const Vector2d& at_m) {
    return Ground(world).height_m(at_m);
}

double ground_steps_m(const World& world, const Vector2d& from_m, const Vector2d& to_m) {
    return Ground(world).steps_m(from_m, to_m);
}

}  // namespace flownav::sim
