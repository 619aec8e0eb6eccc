#include "flownav/obstacles/dynamic_objects.h"

#include <algorithm>
#include <cmath>

#include "flownav/core/plane_geometry.h"
#include "flownav/obstacles/points.h"

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

constexpr double drift_tolerance = 0.2;  // share of the larger of two drifts
constexpr double deviations = 3.0;
constexpr double across_min_px = 2.5;  // roll and sway of the robot cause smaller ones
constexpr double border_px = 8.0;      // a region that ends this near the lower border may extend below it
constexpr double row_sigma_px = 4.6;   // of the contact, which may lie anywhere in the lowest block
constexpr double below_horizon_min = 0.05;
constexpr double relative_sigma_max = 1.0 / 3.0;  // share of the distance
constexpr double height_min_m = -0.2;  // lower points do not belong to an object that stands at the contact

std::optional<double> ground_ahead(const Vector2d& at_px, const RayMapper& mapper) {
    const CameraMount& mount = mapper.camera().mount;
    const PlaneGeometry plane(mount);
    const Vector2d at = mapper.ray(at_px);
    if (plane.below_horizon(at) < below_horizon_min) return std::nullopt;
    // Eq. (8)
    return point_in_robot(at, 1.0 / plane.ground_inverse_depth(at), mount).x();
}

}  // namespace

bool similar_drift(const Classification& p, const Classification& q) {
    const double difference = (p.drift - q.drift).norm();
    return difference < std::max(drift_tolerance * std::max(p.drift.norm(), q.drift.norm()),
                                 deviations * std::hypot(p.drift_sigma, q.drift_sigma));
}

bool may_move(const Classification& classification) {
    const bool backward = classification.inverse_depth < 0.0 &&
                          -classification.inverse_depth > deviations * classification.sigma;
    return classification.label == BlockLabel::Eliminated &&
           (classification.across_px > across_min_px || backward);
}

std::optional<GroundContact> ground_contact(const Vector2d& lowest_px, const RayMapper& newest) {
    if (lowest_px.y() > newest.camera().height_px - border_px) return std::nullopt;
    const auto ahead = ground_ahead(lowest_px, newest);
    const auto farther = ground_ahead(lowest_px - Vector2d(0.0, row_sigma_px), newest);
    if (!ahead || !farther) return std::nullopt;
    const GroundContact contact{*ahead, std::abs(*farther - *ahead)};
    if (!(contact.sigma_m < relative_sigma_max * contact.forward_m)) return std::nullopt;
    return contact;
}

std::optional<ObstaclePoint> moving_point(const Vector2d& at_px, const GroundContact& contact,
                                          const RayMapper& newest, const ObstacleParams& params) {
    const CameraMount& mount = newest.camera().mount;
    const PlaneGeometry plane(mount);
    const Vector2d at = newest.ray(at_px);
    const double forward_per_depth = plane.a - plane.b * at.y();
    if (forward_per_depth <= 0.0) return std::nullopt;
    ObstaclePoint point;
    point.position_m = point_in_robot(at, (contact.forward_m - mount.forward_m) / forward_per_depth, mount);
    const double range = point.position_m.head<2>().norm();
    if (range > params.range_max_m || point.position_m.z() > params.height_max_m ||
        point.position_m.z() < height_min_m)
        return std::nullopt;
    point.sigma_m = contact.sigma_m / contact.forward_m * range;
    point.at_px = at_px;
    point.moving = true;
    return point;
}

}  // namespace flownav::obstacles
