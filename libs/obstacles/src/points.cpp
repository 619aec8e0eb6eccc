#include "flownav/obstacles/points.h"

#include <cmath>

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double half_block_px = 8.0;
constexpr double half_width_px = 6.0;  // of a floor patch; thin obstacles at the edge hardly change a vector
constexpr double relative_sigma_max = 0.12;  // share of the range
constexpr double below_horizon_min = 0.02;

std::optional<Vector2d> ground_point(const Vector2d& at_px, const RayMapper& mapper) {
    const PlaneGeometry plane(mapper.camera().mount);
    const Vector2d at = mapper.ray(at_px);
    if (plane.below_horizon(at) < below_horizon_min) return std::nullopt;
    return point_in_robot(at, 1.0 / plane.ground_inverse_depth(at), mapper.camera().mount).head<2>();
}

}  // namespace

Vector3d point_in_robot(const Vector2d& at, double depth_m, const CameraMount& mount) {
    const PlaneGeometry plane(mount);
    return {mount.forward_m + depth_m * (plane.a - plane.b * at.y()), mount.left_m - depth_m * at.x(),
            mount.height_m - depth_m * plane.below_horizon(at)};
}

std::optional<ObstaclePoint> obstacle_point(const Classification& classification, const Vector2d& last_at_px,
                                            const Pose2& T_end_mid, const CameraMount& mount,
                                            double sigma_travel_relative, const ObstacleParams& params) {
    const double relative =
        std::hypot(classification.sigma / classification.inverse_depth, sigma_travel_relative);
    const Vector3d p = point_in_robot(classification.at, 1.0 / classification.inverse_depth, mount);
    const double range = p.head<2>().norm();
    if (!(relative < relative_sigma_max) || range > params.range_max_m || p.z() > params.height_max_m) {
        return std::nullopt;
    }
    ObstaclePoint point;
    point.position_m << transform(T_end_mid, p.head<2>()), p.z();
    point.sigma_m = relative * range;
    point.at_px = last_at_px;
    return point;
}

std::optional<GroundPatch> ground_patch(const Vector2d& centre_px, const RayMapper& reference,
                                        const Pose2& T_end_reference, double range_max_m) {
    const auto near = ground_point(centre_px + Vector2d(0, half_block_px), reference);
    const auto far = ground_point(centre_px - Vector2d(0, half_block_px), reference);
    if (!near || !far || far->norm() > range_max_m) return std::nullopt;
    const auto left = ground_point(centre_px - Vector2d(half_width_px, 0), reference);
    const auto right = ground_point(centre_px + Vector2d(half_width_px, 0), reference);
    const double width_m = left && right ? (*left - *right).norm() : 0.0;
    return GroundPatch{transform(T_end_reference, *near), transform(T_end_reference, *far), width_m};
}

}  // namespace flownav::obstacles
