#include "candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace flownav::testing {

using Eigen::Vector3d;

TileFrustum::TileFrustum(Vector3d origin_m, const std::array<Vector3d, 4>& corners)
    : origin_m_(std::move(origin_m)) {
    const Vector3d centre = corners[0] + corners[1] + corners[2] + corners[3];
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector3d normal = corners[i].cross(corners[(i + 1) % 4]);
        inward_[i] = normal.dot(centre) < 0.0 ? Vector3d(-normal) : normal;
    }
}

bool TileFrustum::may_show(const Solid& s) const {
    const double half_y = s.shape.shape == Shape::Cylinder ? s.shape.half_x_m : s.shape.half_y_m;
    std::array<Vector3d, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        const Vector3d local((i & 1U) != 0 ? s.shape.half_x_m : -s.shape.half_x_m,
                             (i & 2U) != 0 ? half_y : -half_y,
                             (i & 4U) != 0 ? s.shape.z_high_m : s.shape.z_low_m);
        corners[i] =
            s.to_world(local) + Vector3d(s.shape.centre_m.x(), s.shape.centre_m.y(), 0.0) - origin_m_;
    }
    return std::all_of(inward_.begin(), inward_.end(), [&](const Vector3d& inward) {
        return std::any_of(corners.begin(), corners.end(),
                           [&](const Vector3d& p) { return inward.dot(p) >= 0.0; });
    });
}

std::vector<int> candidates(const std::vector<Solid>& solids, const TileFrustum& frustum) {
    std::vector<int> found;
    for (std::size_t i = 0; i < solids.size(); ++i)
        if (frustum.may_show(solids[i])) found.push_back(static_cast<int>(i));
    return found;
}

}  // namespace flownav::testing
