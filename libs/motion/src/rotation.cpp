#include "rotation.h"

#include <algorithm>
#include <cmath>

#include "background.h"
#include "flownav/motion/robust.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

constexpr double horizon_margin = 0.06;  // a y + b below which (4) is too noisy to start from
constexpr double noise_factor_min = 0.5;
constexpr double noise_factor_max = 3.0;
constexpr double cluster_gap_px = 0.2;  // between vectors of one background
constexpr int biweight_steps = 4;
constexpr double determinant_min = 1e-3;  // relative; below yaw and pitch cannot be told apart

double start_omega(const std::vector<MotionSample>& samples, const CameraModel& camera,
                   const Vector2d& direction, MotionScratch& scratch) {
    const PlaneGeometry plane(camera.mount);
    scratch.omegas.clear();
    for (const MotionSample& s : samples) {
        if (plane.below_horizon(s.ray.at) < horizon_margin) continue;
        scratch.omegas.push_back({omega_of(s.ray, plane, direction), s.ray.at});
    }
    return background_omega(scratch.omegas, cluster_gap_px / camera.fx_px, scratch.values);
}

/// The part of f = (S/Z) e + omega h + pitch p across e knows neither S nor Z: one equation a vector.
void set_up(const std::vector<MotionSample>& samples, const CameraModel& camera, const Vector2d& direction,
            MotionScratch& scratch) {
    const PlaneGeometry plane(camera.mount);
    scratch.across.clear();
    for (const MotionSample& s : samples) {
        const Vector2d e = plane.e(s.ray.at, direction);
        if (e.norm() < 1e-6) continue;
        const double deviation = deviation_across(e, s.ray.sigma);
        const double unit = e.norm() * deviation;
        scratch.across.push_back({cross(e, plane.h(s.ray.at)) / unit,
                                  cross(e, PlaneGeometry::p(s.ray.at)) / unit, cross(e, s.ray.flow) / unit,
                                  1.0, deviation / deviation_across(e, one_pixel(camera))});
    }
}

double residual(const MotionScratch::Across& row, const Rotation& r) {
    return row.measured - row.turn * r.omega_rad - row.pitch * r.pitch_rad;
}

/// Weighted least squares; without pitch when the model has none or the vectors cannot tell it from yaw.
void solve(const MotionScratch& scratch, MotionModel model, Rotation& r) {
    double tt = 0, tp = 0, pp = 0, tm = 0, pm = 0;
    for (const auto& row : scratch.across) {
        tt += row.weight * row.turn * row.turn;
        tp += row.weight * row.turn * row.pitch;
        pp += row.weight * row.pitch * row.pitch;
        tm += row.weight * row.turn * row.measured;
        pm += row.weight * row.pitch * row.measured;
    }
    const double determinant = tt * pp - tp * tp;
    if (model == MotionModel::YawPitch && determinant > determinant_min * tt * pp) {
        r.omega_rad = (pp * tm - tp * pm) / determinant;
        r.pitch_rad = (tt * pm - tp * tm) / determinant;
        r.sigma_omega_rad = r.noise_factor * std::sqrt(pp / determinant);
    } else if (tt > 0.0) {
        r.omega_rad = tm / tt;
        r.pitch_rad = 0.0;
        r.sigma_omega_rad = r.noise_factor / std::sqrt(tt);
    }
}

}  // namespace

double noise_factor_of(std::vector<double>& residuals) {
    return std::clamp(robust_deviation(residuals), noise_factor_min, noise_factor_max);
}

double omega_of(const RayFlow& ray, const PlaneGeometry& plane, const Vector2d& travel) {
    const Vector2d e = plane.e(ray.at, travel);
    // Eq. (4)
    return cross(e, ray.flow) / cross(e, plane.h(ray.at));
}

Rotation fit_rotation(const std::vector<MotionSample>& samples, const CameraModel& camera,
                      const Vector2d& direction, const MotionParams& params, MotionScratch& scratch) {
    Rotation r;
    r.omega_rad = start_omega(samples, camera, direction, scratch);
    set_up(samples, camera, direction, scratch);
    for (int step = 0; step < biweight_steps; ++step) {
        scratch.values.clear();
        for (const auto& row : scratch.across) scratch.values.push_back(residual(row, r));
        r.noise_factor = noise_factor_of(scratch.values);
        for (auto& row : scratch.across) row.weight = biweight(residual(row, r) / r.noise_factor);
        solve(scratch, params.model, r);
    }
    for (const auto& row : scratch.across)
        r.inliers += std::abs(residual(row, r)) * row.deviation_px < params.lambda_px;
    return r;
}

}  // namespace flownav
