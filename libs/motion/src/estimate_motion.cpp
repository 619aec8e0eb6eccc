#include "flownav/motion/estimate_motion.h"

#include <cmath>

#include "flownav/motion/robust.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

constexpr double horizon_margin = 0.06;  // a y + b below which (4) is too noisy to start from
constexpr double noise_min_px = 0.03;    // no block matcher is better
constexpr double noise_max_px = 0.7;     // nor may outliers make the scale look worse
constexpr int biweight_steps = 4;
constexpr int travel_rounds = 2;  // e depends on the travel that it measures
constexpr int window_support_min = 6;

struct Rotation {
    double omega_rad = 0.0;
    double pitch_rad = 0.0;
    double sigma_omega_rad = 0.0;
    double noise_px = noise_max_px;
    int inliers = 0;
};

struct Travel {
    double along_m = 0.0;
    double sigma_m = 0.0;
    int support = 0;
};

Vector2d direction_of(const Vector2d& travel) {
    const double length = travel.norm();
    return length > 1e-6 ? Vector2d(travel / length) : Vector2d(1.0, 0.0);
}

double noise_of(std::vector<double>& residuals_px) {
    return std::clamp(robust_deviation(residuals_px), noise_min_px, noise_max_px);
}

double residual_px(const MotionScratch::Row& row, const Rotation& r) {
    return row.value - row.turn * r.omega_rad - row.pitch * r.pitch_rad;
}

/// The component of f = (S/Z) e + omega h + pitch p across e knows neither S nor Z: one equation a vector, in
/// pixels. Dividing it by the turn's factor would give (4) and its singularity on the horizon.
void fill_rows(const std::vector<MotionSample>& samples, const CameraModel& camera,
               const PlaneGeometry& plane, const Vector2d& travel, MotionScratch& scratch) {
    scratch.rows.clear();
    for (const MotionSample& s : samples) {
        const Vector2d e = plane.e(s.ray.at, travel);
        const double length = e.norm();
        if (length < 1e-6) continue;
        const double unit = length * pixel_across(e, camera);
        scratch.rows.push_back({cross(e, plane.h(s.ray.at)) / unit,
                                cross(e, PlaneGeometry::p(s.ray.at)) / unit, cross(e, s.ray.flow) / unit,
                                1.0});
    }
}

double start_omega(const std::vector<MotionSample>& samples, const PlaneGeometry& plane,
                   const Vector2d& travel, MotionScratch& scratch) {
    scratch.values.clear();
    for (const MotionSample& s : samples) {
        if (plane.below_horizon(s.ray.at) < horizon_margin) continue;
        scratch.values.push_back(omega_of(s.ray, plane, travel));
    }
    return shorth(scratch.values);
}

/// One weighted least-squares step; the pitch stays as it is when the model has none or cannot be told.
void weighted_step(const MotionScratch& scratch, MotionModel model, Rotation& r) {
    double tt = 0, tp = 0, pp = 0, ty = 0, py = 0;
    for (const auto& row : scratch.rows) {
        tt += row.weight * row.turn * row.turn;
        tp += row.weight * row.turn * row.pitch;
        pp += row.weight * row.pitch * row.pitch;
        ty += row.weight * row.turn * row.value;
        py += row.weight * row.pitch * row.value;
    }
    const double det = tt * pp - tp * tp;
    if (tt <= 0.0) return;
    if (model == MotionModel::YawPitch && det > 1e-3 * tt * pp) {
        r.omega_rad = (pp * ty - tp * py) / det;
        r.pitch_rad = (tt * py - tp * ty) / det;
        r.sigma_omega_rad = r.noise_px * std::sqrt(pp / det);
    } else {
        r.omega_rad = ty / tt;
        r.sigma_omega_rad = r.noise_px / std::sqrt(tt);
    }
}

Rotation fit_rotation(double omega_start_rad, const MotionParams& params, MotionScratch& scratch) {
    Rotation r;
    r.omega_rad = omega_start_rad;
    for (int step = 0; step < biweight_steps; ++step) {
        scratch.values.clear();
        for (const auto& row : scratch.rows) scratch.values.push_back(residual_px(row, r));
        r.noise_px = noise_of(scratch.values);
        for (auto& row : scratch.rows) row.weight = biweight(residual_px(row, r) / r.noise_px);
        weighted_step(scratch, params.model, r);
    }
    for (const auto& row : scratch.rows) r.inliers += std::abs(residual_px(row, r)) < params.lambda_px;
    return r;
}

/// (10) and (12): travel of every vector of the ground window that fits the rotation, with its deviation.
void window_travels(const std::vector<MotionSample>& samples, const CameraModel& camera,
                    const PlaneGeometry& plane, const Vector2d& travel, const Rotation& r, double lambda_px,
                    MotionScratch& scratch) {
    scratch.rows.clear();
    for (const MotionSample& s : samples) {
        const double ground = plane.ground_inverse_depth(s.ray.at);
        if (!s.in_ground_window || ground <= 0.0) continue;
        const Vector2d e = plane.e(s.ray.at, travel);
        // Eq. (9)
        const Vector2d d =
            s.ray.flow - r.omega_rad * plane.h(s.ray.at) - r.pitch_rad * PlaneGeometry::p(s.ray.at);
        if (std::abs(cross(e, d)) > lambda_px * e.norm() * pixel_across(e, camera)) continue;
        // Eq. (10)
        const double travel_over_depth = e.dot(d) / e.squaredNorm();
        const double sigma = pixel_along(e, camera) / (e.norm() * ground);
        scratch.rows.push_back({sigma, 0.0, travel_over_depth / ground, 1.0});
    }
}

Travel fit_travel(MotionScratch& scratch) {
    Travel t;
    scratch.values.clear();
    for (const auto& row : scratch.rows) scratch.values.push_back(row.value);
    t.along_m = shorth(scratch.values);  // Eq. (12)
    for (int step = 0; step < 2; ++step) {
        scratch.values.clear();
        for (const auto& row : scratch.rows) scratch.values.push_back((row.value - t.along_m) / row.turn);
        const double noise_px = noise_of(scratch.values);
        double sum = 0.0, weights = 0.0;
        t.support = 0;
        for (const auto& row : scratch.rows) {
            const double robust = biweight((row.value - t.along_m) / (row.turn * noise_px));
            const double weight = robust / (row.turn * row.turn);
            sum += weight * row.value;
            weights += weight;
            t.support += robust > 0.0;
        }
        if (weights <= 0.0) return {};
        t.along_m = sum / weights;
        t.sigma_m = noise_px / std::sqrt(weights);
    }
    return t;
}

}  // namespace

double omega_of(const RayFlow& ray, const PlaneGeometry& plane, const Vector2d& travel) {
    const Vector2d e = plane.e(ray.at, travel);
    // Eq. (4)
    return cross(e, ray.flow) / cross(e, plane.h(ray.at));
}

MotionEstimate estimate_motion(const std::vector<MotionSample>& samples, const CameraModel& camera,
                               const MotionPrediction& prediction, const MotionParams& params,
                               MotionScratch& scratch) {
    const PlaneGeometry plane(camera.mount);
    MotionEstimate estimate;
    EgoMotion& m = estimate.motion;
    m.omega_rad = prediction.omega_rad;
    m.pitch_rad = prediction.pitch_rad;
    m.forward_m = prediction.forward_m;
    if (samples.empty()) return estimate;

    for (int round = 0; round < travel_rounds; ++round) {
        const Vector2d direction = direction_of(camera_travel(camera.mount, m.forward_m, m.omega_rad));
        fill_rows(samples, camera, plane, direction, scratch);
        const double start = start_omega(samples, plane, direction, scratch);
        const Rotation r = fit_rotation(start, params, scratch);
        m.omega_rad = r.omega_rad;
        m.pitch_rad = r.pitch_rad;
        m.sigma_omega_rad = r.sigma_omega_rad;
        m.inliers = r.inliers;
        m.omega_measured = true;
        estimate.noise_px = r.noise_px;

        window_travels(samples, camera, plane, direction, r, params.lambda_px, scratch);
        const Travel t = fit_travel(scratch);
        m.ground_window = t.support;
        m.forward_measured = t.support >= window_support_min;
        m.forward_m = prediction.forward_m;
        if (m.forward_measured) {
            m.forward_m = t.along_m * direction.x() + m.omega_rad * camera.mount.left_m;
            m.sigma_forward_m = t.sigma_m;
        }
    }
    return estimate;
}

}  // namespace flownav
