#include "solid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flownav::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

std::uint32_t add_vertex(Mesh& mesh, const Vector3d& at_m, const Vector2d& uv_m) {
    const Eigen::Vector3f p = at_m.cast<float>();
    const Eigen::Vector2f t = uv_m.cast<float>();
    mesh.vertices.push_back({p.x(), p.y(), p.z(), t.x(), t.y()});
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
}

/// A polygon that lies as far outside a circle with its corners as inside with its sides.
struct Polygon {
    int sides = 0;
    double corner_m = 0.0;  ///< from the middle to a corner
};

Polygon polygon(double radius_m, double deviation_m) {
    const double angle = std::acos(1.0 - std::min(2 * deviation_m / radius_m, 0.5));
    const int sides = std::clamp(static_cast<int>(std::ceil(M_PI / angle)), 16, 180);
    return {sides, radius_m * 2.0 / (1.0 + std::cos(M_PI / sides))};
}

Mesh box_mesh(const Box& box) {
    Mesh mesh;
    const Vector3d half = box.size_m / 2;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            // Seen from outside, `across` points to the right and `up` upward.
            Vector3d normal = Vector3d::Zero();
            normal[axis] = side;
            const Vector3d up = axis == 2 ? Vector3d::UnitX() : Vector3d::UnitZ();
            const Vector3d across = up.cross(normal);
            const double half_u = std::abs(across.dot(half));
            const double half_v = std::abs(up.dot(half));
            const Vector3d middle = side * half[axis] * Vector3d::Unit(axis);
            const double shift = 0.37 * (2 * axis + (side > 0.0 ? 1 : 0));  // no two faces alike
            const auto corner = [&](double u, double v) {
                return add_vertex(mesh, middle + u * half_u * across + v * half_v * up,
                                  {u * half_u + shift, v * half_v - shift});
            };
            const std::array<std::uint32_t, 4> c = {corner(-1, -1), corner(1, -1), corner(1, 1),
                                                    corner(-1, 1)};
            add_quad(mesh, c[0], c[1], c[2], c[3]);
        }
    }
    return mesh;
}

/// The flat end of a cylinder, a fan about its first vertex.
void add_cap(Mesh& mesh, const Cylinder& cylinder, const Polygon& round, double side) {
    const int n = round.sides;
    const double z = side * cylinder.length_m / 2;
    const std::uint32_t middle = add_vertex(mesh, {0, 0, z}, {side, side});
    for (int i = 0; i < n; ++i) {
        const double angle = side * 2 * M_PI * i / n;
        const Vector2d at = round.corner_m * Vector2d(std::cos(angle), std::sin(angle));
        add_vertex(mesh, {at.x(), at.y(), z}, at + Vector2d(side, side));
    }
    for (int i = 0; i < n; ++i) {
        const auto a = static_cast<std::uint32_t>(1 + i);
        const auto b = static_cast<std::uint32_t>(1 + (i + 1) % n);
        mesh.indices.insert(mesh.indices.end(), {middle, middle + a, middle + b});
    }
}

Mesh cylinder_mesh(const Cylinder& cylinder, double deviation_m) {
    Mesh mesh;
    const Polygon round = polygon(cylinder.radius_m, deviation_m);
    const int n = round.sides;
    const double half = cylinder.length_m / 2;
    std::uint32_t below = 0;
    std::uint32_t above = 0;
    for (int i = 0; i <= n; ++i) {
        const double angle = 2 * M_PI * i / n;
        const Vector2d at = round.corner_m * Vector2d(std::cos(angle), std::sin(angle));
        const double u = cylinder.radius_m * angle;
        const std::uint32_t low = add_vertex(mesh, {at.x(), at.y(), -half}, {u, -half});
        const std::uint32_t high = add_vertex(mesh, {at.x(), at.y(), half}, {u, half});
        if (i > 0) add_quad(mesh, below, low, high, above);
        below = low;
        above = high;
    }
    add_cap(mesh, cylinder, round, 1.0);
    add_cap(mesh, cylinder, round, -1.0);
    return mesh;
}

Mesh sphere_mesh(const Sphere& sphere, double deviation_m) {
    Mesh mesh;
    const Polygon round = polygon(sphere.radius_m, deviation_m);
    const int n = round.sides;
    const int rings = (n + 1) / 2;
    for (int ring = 0; ring <= rings; ++ring) {
        const double latitude = M_PI * ring / rings - M_PI / 2;
        for (int i = 0; i <= n; ++i) {
            const double angle = 2 * M_PI * i / n;
            const Vector3d at(std::cos(angle) * std::cos(latitude), std::sin(angle) * std::cos(latitude),
                              std::sin(latitude));
            // Lengths along the equator shrink with the latitude, as those of the surface do.
            const double u = (angle - M_PI) * std::cos(latitude);
            add_vertex(mesh, round.corner_m * at, sphere.radius_m * Vector2d(u, latitude));
        }
    }
    const auto index = [&](int ring, int i) { return static_cast<std::uint32_t>(ring * (n + 1) + i); };
    for (int ring = 0; ring < rings; ++ring) {
        for (int i = 0; i < n; ++i)
            add_quad(mesh, index(ring, i), index(ring, i + 1), index(ring + 1, i + 1), index(ring + 1, i));
    }
    return mesh;
}

}  // namespace

Mesh mesh_of(const Shape& shape, double deviation_m) {
    if (const auto* box = std::get_if<Box>(&shape)) return box_mesh(*box);
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder_mesh(*cylinder, deviation_m);
    return sphere_mesh(std::get<Sphere>(shape), deviation_m);
}

}  // namespace flownav::sim
