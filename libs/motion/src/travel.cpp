#include "travel.h"

#include <cmath>

#include "flownav/motion/robust.h"

namespace flownav::motion {
namespace {

using Eigen::Vector2d;

constexpr double near_share =
    0.5;  // smallest a y + b of the near floor, as a share of its value at the lower border
constexpr int window_support_min = 6;  // vectors needed in the ground window
constexpr int floor_support_min = 12;  // vectors needed on the near floor when the window has too few
constexpr int biweight_steps = 2;
constexpr double deviation_ratio_max = 0.8;  // of floor to window at which the floor is taken

/// Smallest a y + b of the near floor.
double near_floor(const CameraModel& camera, const PlaneGeometry& plane) {
    return near_share * plane.below_horizon({0.0, (camera.height_px - camera.cy_px) / camera.fy_px});
}

/// Fills scratch.floor with the travel of every vector that sees the near floor and fits the rotation, and
/// scratch.window with those of the ground window.
void floor_travels(const std::vector<MotionSample>& samples, const CameraModel& camera,
                   const Vector2d& direction, const Rotation& r, const MotionParams& params,
                   MotionScratch& scratch) {
    const PlaneGeometry plane(camera.mount);
    const double near = near_floor(camera, plane);
    const Derotation derotated(plane, r.turn.omega_rad, r.turn.pitch_rad, params.geometry);
    const Vector2d one_px = one_pixel(camera);
    scratch.floor.clear();
    scratch.window.clear();
    for (const MotionSample& s : samples) {
        const RayFlow travel = derotated(s.ray);
        if (plane.below_horizon(travel.at) < near) continue;
        const Vector2d e = plane.e(travel.at, direction);
        const Vector2d& d = travel.flow;
        // Eq. (11)
        if (std::abs(cross(e, d)) > params.lambda_px * deviation_of_cross(e, one_px)) continue;
        // Eq. (10), times the depth of the ground
        const double of_ground = 1.0 / (e.squaredNorm() * plane.ground_inverse_depth(travel.at));
        const MotionScratch::TravelEquation row{e.dot(d) * of_ground,
                                                deviation_of_dot(e, s.ray.sigma) * of_ground};
        scratch.floor.push_back(row);
        if (s.in_ground_window) scratch.window.push_back(row);
    }
}

Travel robust_mean(const std::vector<MotionScratch::TravelEquation>& rows, std::vector<double>& values) {
    Travel t;
    values.clear();
    for (const auto& row : rows) values.push_back(row.travel_m);
    // Eq. (12)
    t.along_m = shorth(values);
    for (int step = 0; step < biweight_steps; ++step) {
        values.clear();
        for (const auto& row : rows) values.push_back((row.travel_m - t.along_m) / row.sigma_m);
        const double noise_factor = noise_factor_of(values);
        double sum = 0.0, weights = 0.0;
        t.support = 0;
        for (const auto& row : rows) {
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
    floor_travels(samples, camera, direction, rotation, params, scratch);
    const Travel window = robust_mean(scratch.window, scratch.values);
    const Travel floor = robust_mean(scratch.floor, scratch.values);
    const bool anchored = window.support >= window_support_min;
    if (floor.support < floor_support_min) return anchored ? window : Travel{};
    // The whole floor is taken when it agrees with the window and is clearly more precise.
    const bool same = std::abs(floor.along_m - window.along_m) < 3.0 * window.sigma_m;
    return anchored && !(same && floor.sigma_m < deviation_ratio_max * window.sigma_m) ? window : floor;
}

}  // namespace flownav::motion
