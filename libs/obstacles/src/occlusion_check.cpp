#include "flownav/obstacles/occlusion_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

constexpr int bins_per_degree = 2;
constexpr int bins = 360 * bins_per_degree;
constexpr int reach = 3;  // bins to either side; half a block of a camera of 90 degrees and 640 pixels

int bin_of(const Vector2d& from_camera_m) {
    const double turns = std::atan2(from_camera_m.y(), from_camera_m.x()) / (2.0 * M_PI) + 0.5;
    return std::clamp(static_cast<int>(turns * bins), 0, bins - 1);
}

/// Shortens a patch to the part nearer than `range_m`; false when no part is.
bool cut(GroundPatch& patch, const Vector2d& camera_m, double range_m) {
    const double near_m = (patch.near_m - camera_m).norm();
    const double far_m = (patch.far_m - camera_m).norm();
    if (near_m >= range_m) return false;
    if (far_m > range_m)
        patch.far_m = patch.near_m + (range_m - near_m) / (far_m - near_m) * (patch.far_m - patch.near_m);
    return true;
}

}  // namespace

void remove_occluded_floor(const std::vector<ObstaclePoint>& points, const Vector2d& camera_m,
                           std::vector<GroundPatch>& ground) {
    std::array<double, bins> nearest_m;
    nearest_m.fill(std::numeric_limits<double>::infinity());
    for (const ObstaclePoint& point : points) {
        const Vector2d at_m = point.position_m.head<2>() - camera_m;
        const int middle = bin_of(at_m);
        for (int i = middle - reach; i <= middle + reach; ++i) {
            double& nearest = nearest_m[static_cast<std::size_t>((i + bins) % bins)];
            nearest = std::min(nearest, at_m.norm());
        }
    }
    const auto is_hidden = [&](GroundPatch& patch) {
        const int bin = bin_of((patch.near_m + patch.far_m) / 2 - camera_m);
        return !cut(patch, camera_m, nearest_m[static_cast<std::size_t>(bin)]);
    };
    ground.erase(std::remove_if(ground.begin(), ground.end(), is_hidden), ground.end());
}

}  // namespace flownav::obstacles
