#include "flownav/sim/plan_view.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "flownav/math/convex_hull.h"

namespace flownav::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double upright_cosine = 1.0 - 1e-12;

/// A convex body by its corners and edges.
struct Body {
    std::vector<Vector3d> corners_m;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
};

/// The prism over a polygon that goes from -half_length to +half_length along z.
Body prism(const std::vector<Vector2d>& base_m, double half_length_m) {
    Body body;
    const std::size_t n = base_m.size();
    for (std::size_t i = 0; i < n; ++i) {
        body.corners_m.emplace_back(base_m[i].x(), base_m[i].y(), -half_length_m);
        body.corners_m.emplace_back(base_m[i].x(), base_m[i].y(), half_length_m);
        const std::size_t next = (i + 1) % n;
        body.edges.insert(body.edges.end(),
                          {{2 * i, 2 * i + 1}, {2 * i, 2 * next}, {2 * i + 1, 2 * next + 1}});
    }
    return body;
}

std::vector<Vector2d> rectangle(const Vector3d& size_m) {
    const double x = size_m.x() / 2;
    const double y = size_m.y() / 2;
    return {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
}

std::vector<Vector2d> around_circle(double radius_m) {
    constexpr int sides = 32;
    std::vector<Vector2d> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle_rad = 2.0 * M_PI * i / sides;
        corners.emplace_back(Vector2d(std::cos(angle_rad), std::sin(angle_rad)) * radius_m /
                             std::cos(M_PI / sides));
    }
    return corners;
}

/// The part of a convex body between two heights, seen from above: the hull of its corners there and of the
/// points where its edges pass the heights.
std::optional<PlanShape> slab_of(Body body, const Isometry3d& T_world_body, double low_m, double high_m) {
    for (Vector3d& corner : body.corners_m) corner = T_world_body * corner;
    std::vector<Vector2d> points;
    for (const Vector3d& corner : body.corners_m)
        if (corner.z() >= low_m && corner.z() <= high_m) points.emplace_back(corner.head<2>());
    for (const auto& [i, j] : body.edges) {
        const Vector3d& a = body.corners_m[i];
        const Vector3d& b = body.corners_m[j];
        for (const double height_m : {low_m, high_m}) {
            if ((a.z() < height_m) == (b.z() < height_m)) continue;
            points.emplace_back((a + (b - a) * ((height_m - a.z()) / (b.z() - a.z()))).head<2>());
        }
    }
    if (points.size() < 3) return std::nullopt;
    Polygon outline = convex_hull(std::move(points));
    if (outline.size() < 3) return std::nullopt;
    return outline;
}

bool overlaps(double centre_m, double half_m, double low_m, double high_m) {
    return centre_m + half_m > low_m && centre_m - half_m < high_m;
}

std::optional<PlanShape> plan_of(const Box& box, const Isometry3d& T_world, double low_m, double high_m) {
    if (std::abs(T_world.linear()(2, 2)) < upright_cosine)
        return slab_of(prism(rectangle(box.size_m), box.size_m.z() / 2), T_world, low_m, high_m);
    if (!overlaps(T_world.translation().z(), box.size_m.z() / 2, low_m, high_m)) return std::nullopt;
    Polygon corners;
    for (const Vector2d& corner : rectangle(box.size_m))
        corners.emplace_back((T_world * Vector3d(corner.x(), corner.y(), 0.0)).head<2>());
    if (T_world.linear()(2, 2) < 0.0) std::reverse(corners.begin(), corners.end());
    return corners;
}

std::optional<PlanShape> plan_of(const Cylinder& cylinder, const Isometry3d& T_world, double low_m,
                                 double high_m) {
    const double half_m = cylinder.length_m / 2;
    if (std::abs(T_world.linear()(2, 2)) < upright_cosine)
        return slab_of(prism(around_circle(cylinder.radius_m), half_m), T_world, low_m, high_m);
    if (!overlaps(T_world.translation().z(), half_m, low_m, high_m)) return std::nullopt;
    return Disc{T_world.translation().head<2>(), cylinder.radius_m};
}

std::optional<PlanShape> plan_of(const Sphere& sphere, const Isometry3d& T_world, double low_m,
                                 double high_m) {
    const double centre_m = T_world.translation().z();
    const double off_m = centre_m - std::clamp(centre_m, low_m, high_m);
    if (std::abs(off_m) >= sphere.radius_m) return std::nullopt;
    return Disc{T_world.translation().head<2>(),
                std::sqrt(sphere.radius_m * sphere.radius_m - off_m * off_m)};
}

}  // namespace

std::optional<PlanShape> plan_view(const Shape& shape, const Isometry3d& T_world_shape, double low_m,
                                   double high_m) {
    return std::visit([&](const auto& s) { return plan_of(s, T_world_shape, low_m, high_m); }, shape);
}

double bounding_radius_m(const Shape& shape) {
    if (const auto* box = std::get_if<Box>(&shape)) return box->size_m.norm() / 2;
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius_m;
    const auto& cylinder = std::get<Cylinder>(shape);
    // The prism that stands for a tilted one is a little wider.
    return std::hypot(1.005 * cylinder.radius_m, cylinder.length_m / 2);
}

}  // namespace flownav::sim
