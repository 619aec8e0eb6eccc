#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace flownav {

/// Corners of a simple polygon, counter-clockwise.
using Polygon = std::vector<Eigen::Vector2d>;

inline double distance_to_segment_m(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                                    const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = b - a;
    const double length2 = along.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (p - a - share * along).norm();
}

/// Distance of a point to the outline of a polygon, negative inside.
inline double signed_distance_m(const Polygon& polygon, const Eigen::Vector2d& p) {
    double distance = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Eigen::Vector2d& a = polygon[j];
        const Eigen::Vector2d& b = polygon[i];
        distance = std::min(distance, distance_to_segment_m(p, a, b));
        const bool crosses = (a.y() > p.y()) != (b.y() > p.y());
        if (crosses && p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside ? -distance : distance;
}

/// Area of a polygon: positive when its corners run counter-clockwise.
inline double signed_area_m2(const Polygon& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        twice += polygon[j].x() * polygon[i].y() - polygon[j].y() * polygon[i].x();
    return twice / 2;
}

/// Distance of the farthest corner from the origin: the radius of a turn on the spot.
inline double circumscribed_radius_m(const Polygon& polygon) {
    double radius = 0.0;
    for (const Eigen::Vector2d& corner : polygon) radius = std::max(radius, corner.norm());
    return radius;
}

}  // namespace flownav
