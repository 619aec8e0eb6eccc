#pragma once

#include <algorithm>

#include "flownav/math/footprint.h"

namespace flownav {

/// Convex hull, counter-clockwise (Andrew's monotone chain). Fewer than 3 corners when the points lie on a
/// line.
inline Polygon convex_hull(std::vector<Eigen::Vector2d> points) {
    using Eigen::Vector2d;
    if (points.size() < 3) return points;
    std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
        return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
    });
    const auto turn = [](const Vector2d& p, const Vector2d& q) { return p.x() * q.y() - p.y() * q.x(); };
    Polygon corners;
    const auto add = [&](const Vector2d& p, std::size_t fixed) {
        while (corners.size() >= fixed + 2 &&
               turn(corners.back() - corners[corners.size() - 2], p - corners.back()) <= 0.0)
            corners.pop_back();
        corners.push_back(p);
    };
    for (const Vector2d& p : points) add(p, 0);
    const std::size_t lower = corners.size() - 1;
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
    corners.pop_back();
    return corners;
}

}  // namespace flownav
