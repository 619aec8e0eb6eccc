#include "travel.h"

#include <cmath>

#include "flownav/motion/robust.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

constexpr double near_share = 0.5;     // of a y + b at the lower border: the near floor
constexpr int window_support_min = 6;  // vectors of the ground window
constexpr int floor_support_min = 12;  // vectors anywhere on the floor, when the window has too few
constexpr int biweight_steps = 2;
constexpr double much_better = 0.8;  // share of the deviation

/// a y + b from which on the floor is near.
double near_floor(const CameraModel& camera, const PlaneGeometry& plane) {
    return near_share * plane.below_horizon({0.0, (camera.height_px - camera.cy_px) / camera.fy_px});
}

/// Travel of every vector that looks at the near floor and fits the rotation.
void floor_travels(const std::vector<MotionSample>& samples, bool window_only, const CameraModel& camera,
                   const Vector2d& direction, const Rotation& r, const MotionParams& params,
                   MotionScratch& scratch) {
    const PlaneGeometry plane(camera.mount);
    const double near = near_floor(camera, plane);
    const Derotation derotated(plane, r.turn.omega_rad, r.turn.pitch_rad, params.geometry);
    scratch.along.clear();
    for (const MotionSample& s : samples) {
        if (window_only && !s.in_ground_window) continue;
        const RayFlow travel = derotated(s.ray);
        if (plane.below_horizon(travel.at) < near) continue;
        const Vector2d e = plane.e(travel.at, direction);
        const Vector2d& d = travel.flow;
        // Eq. (11)
        const double one_px_across = deviation_across(e, one_pixel(camera));
        if (std::abs(cross(e, d)) > params.lambda_px * e.norm() * one_px_across) continue;
        // Eq. (10)
        const double travel_over_depth = e.dot(d) / e.squaredNorm();
        const double ground = plane.ground_inverse_depth(travel.at);
        scratch.along.push_back(
            {travel_over_depth / ground, deviation_along(e, s.ray.sigma) / (e.norm() * ground)});
    }
}

Travel robust_mean(MotionScratch& scratch) {
    Travel t;
    scratch.values.clear();
    for (const auto& row : scratch.along) scratch.values.push_back(row.travel_m);
    // Eq. (12)
    t.along_m = shorth(scratch.values);
    for (int step = 0; step < biweight_steps; ++step) {
        scratch.values.clear();
        for (const auto& row : scratch.along)
            scratch.values.push_back((row.travel_m - t.along_m) / row.sigma_m);
        const double noise_factor = noise_factor_of(scratch.values);
        double sum = 0.0, weights = 0.0;
        t.support = 0;
        for (const auto& row : scratch.along) {
            const double robust = biweight((row.travel_m - t.along_m) / (row.sigma_m * noise_factor));
            const double weight = robust / (row.sigma_m * row.sigma_m);
            sum += weight * row.travel_m;
            weights += weight;
            t.support += robust > 0.0;
        }
        if (weights <= 0.0) return {};
        t.along_m = sum / weights;
        t.sigma_m = noise_factor / std::sqrt(weights);
    }
    return t;
}

}  // namespace

Travel fit_travel(const std::vector<MotionSample>& samples, const CameraModel& camera,
                  const Vector2d& direction, const Rotation& rotation, const MotionParams& params,
                  MotionScratch& scratch) {
    floor_travels(samples, true, camera, direction, rotation, params, scratch);
    const Travel window = robust_mean(scratch);
    const bool anchored = window.support >= window_support_min;
    floor_travels(samples, false, camera, direction, rotation, params, scratch);
    const Travel floor = robust_mean(scratch);
    if (floor.support < floor_support_min) return anchored ? window : Travel{};
    // More vectors are better where those of the window are few and poor, and only if they say the same.
    const bool same = std::abs(floor.along_m - window.along_m) < 3.0 * window.sigma_m;
    return anchored && !(same && floor.sigma_m < much_better * window.sigma_m) ? window : floor;
}

}  // namespace flownav
