#include "candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace flownav::sim {

using Eigen::Vector3d;

TileFrustum::TileFrustum(Vector3d origin_m, const std::array<Vector3d, 4>& corners)
    : origin_m_(std::move(origin_m)) {
    const Vector3d centre = corners[0] + corners[1] + corners[2] + corners[3];
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector3d normal = corners[i].cross(corners[(i + 1) % 4]);
        inward_[i] = normal.dot(centre) < 0.0 ? Vector3d(-normal) : normal;
    }
}

namespace {

/// Half the size of the box around a shape, in its frame.
Vector3d half_size_m(const Box& box) {
    return 0.5 * box.size_m;
}
Vector3d half_size_m(const Cylinder& cylinder) {
    return {cylinder.radius_m, cylinder.radius_m, 0.5 * cylinder.length_m};
}
Vector3d half_size_m(const Sphere& sphere) {
    return Vector3d::Constant(sphere.radius_m);
}

}  // namespace

bool TileFrustum::may_show(const PlacedSolid& s) const {
    const Vector3d half = std::visit([](const auto& shape) { return half_size_m(shape); }, s.shape);
    std::array<Vector3d, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        const Vector3d local((i & 1U) != 0 ? half.x() : -half.x(), (i & 2U) != 0 ? half.y() : -half.y(),
                             (i & 4U) != 0 ? half.z() : -half.z());
        corners[i] = s.R_world_solid * local + s.centre_m - origin_m_;
    }
    return std::all_of(inward_.begin(), inward_.end(), [&](const Vector3d& inward) {
        return std::any_of(corners.begin(), corners.end(),
                           [&](const Vector3d& p) { return inward.dot(p) >= 0.0; });
    });
}

std::vector<int> candidates(const std::vector<PlacedSolid>& solids, const TileFrustum& frustum) {
    std::vector<int> found;
    for (std::size_t i = 0; i < solids.size(); ++i)
        if (solids[i].visible && frustum.may_show(solids[i])) found.push_back(static_cast<int>(i));
    return found;
}

}  // namespace flownav::sim
