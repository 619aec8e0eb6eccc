#include "flownav/obstacles/occlusion_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "flownav/core/contact_floor.h"

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

/// Distance from the camera to the nearest obstacle in each bin of bearings.
class Horizon {
  public:
    explicit Horizon(const Vector2d& camera_m) : camera_m_(camera_m) {
        nearest_m_.fill(std::numeric_limits<double>::infinity());
    }

    /// Adds an obstacle that reaches over the bins from `right_bin`, to the left, to `left_bin`.
    void add(int right_bin, int left_bin, double range_m) {
        const int wide = (left_bin - right_bin + bins) % bins;
        for (int i = right_bin - reach; i <= right_bin + wide + reach; ++i) {
            double& nearest = nearest_m_[static_cast<std::size_t>((i + bins) % bins)];
            nearest = std::min(nearest, range_m);
        }
    }

    void remove_hidden(std::vector<GroundPatch>& ground) const {
        const auto is_hidden = [&](GroundPatch& patch) {
            const int bin = bin_of((patch.near_m + patch.far_m) / 2 - camera_m_);
            return !cut(patch, camera_m_, nearest_m_[static_cast<std::size_t>(bin)]);
        };
        ground.erase(std::remove_if(ground.begin(), ground.end(), is_hidden), ground.end());
    }

  private:
    Vector2d camera_m_;
    std::array<double, bins> nearest_m_;
};

}  // namespace

void remove_occluded_floor(const std::vector<ObstaclePoint>& points, const Vector2d& camera_m,
                           std::vector<GroundPatch>& ground) {
    Horizon horizon(camera_m);
    for (const ObstaclePoint& point : points) {
        const Vector2d at_m = point.position_m.head<2>() - camera_m;
        const int bin = bin_of(at_m);
        horizon.add(bin, bin, at_m.norm());
    }
    horizon.remove_hidden(ground);
}

void remove_floor_behind_contacts(const ContactScan& contacts, const Vector2d& camera_m,
                                  std::vector<GroundPatch>& ground) {
    Horizon horizon(camera_m);
    for (std::size_t i = 0; i < contacts.strips.size(); ++i) {
        if (contacts.strips[i].kind != BeamKind::Obstacle) continue;
        const ContactLine line = line_of(contacts, static_cast<int>(i));
        const Vector2d left_m = line.left_m - camera_m;
        const Vector2d right_m = line.right_m - camera_m;
        if (std::min(left_m.x(), right_m.x()) <= 0.0) continue;
        horizon.add(bin_of(right_m), bin_of(left_m), std::min(left_m.norm(), right_m.norm()));
    }
    horizon.remove_hidden(ground);
}

}  // namespace flownav::obstacles
