#include "rotation.h"

#include <algorithm>
#include <cmath>

#include "background.h"
#include "consensus.h"
#include "flownav/motion/robust.h"

namespace flownav::motion {
namespace {

using Eigen::Vector2d;

constexpr double horizon_margin =
    0.06;  // smallest a y + b of a vector in the background: below, Eq. (4) is too noisy
constexpr double noise_factor_min = 0.5;
constexpr double noise_factor_max = 3.0;
constexpr double cluster_gap_px = 0.2;  // largest gap between neighbours of one cluster
constexpr int biweight_steps = 4;
constexpr double settled_deviations = 0.01;  // the iteration ends at a smaller change of the turn
constexpr double determinant_min = 1e-3;     // relative; below, yaw and pitch cannot be separated

/// omega of the background after [S], in rad.
double background(const std::vector<MotionSample>& samples, const CameraModel& camera,
                  const Vector2d& direction, MotionScratch& scratch) {
    const PlaneGeometry plane(camera.mount);
    scratch.omegas.clear();
    for (const MotionSample& s : samples) {
        if (plane.below_horizon(s.ray.at) < horizon_margin) continue;
        scratch.omegas.push_back({omega_of(s.ray, plane, direction), s.ray.at});
    }
    return background_omega(scratch.omegas, cluster_gap_px / camera.fx_px, scratch.values);
}

/// Noise factor of the vectors near the rotation; vectors beyond 3 deviations and `lambda_px` are left out.
double noise_factor_about(const RotationHypothesis& turn, double lambda_px, MotionScratch& scratch) {
    scratch.values.clear();
    for (const auto& row : scratch.rotation_equations) {
        const double r = residual(row, turn);
        if (std::abs(r) < 3.0 || std::abs(r) * row.deviation_px < lambda_px) scratch.values.push_back(r);
    }
    return noise_factor_of(scratch.values);
}

/// Weighted least squares. The pitch is 0 when the model has none or the vectors cannot separate it from yaw.
void solve(const MotionScratch& scratch, MotionModel model, Rotation& r) {
    double tt = 0, tp = 0, pp = 0, tm = 0, pm = 0;
    for (const auto& row : scratch.rotation_equations) {
        tt += row.weight * row.turn * row.turn;
        tp += row.weight * row.turn * row.pitch;
        pp += row.weight * row.pitch * row.pitch;
        tm += row.weight * row.turn * row.measured;
        pm += row.weight * row.pitch * row.measured;
    }
    const double determinant = tt * pp - tp * tp;
    if (model == MotionModel::YawPitch && determinant > determinant_min * tt * pp) {
        r.turn.omega_rad = (pp * tm - tp * pm) / determinant;
        r.turn.pitch_rad = (tt * pm - tp * tm) / determinant;
        r.sigma_omega_rad = r.noise_factor * std::sqrt(pp / determinant);
    } else if (tt > 0.0) {
        r.turn.omega_rad = tm / tt;
        r.turn.pitch_rad = 0.0;
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

// The component of f = (S/Z) e + omega h + pitch p across e depends neither on S nor on Z: one equation per
// vector.
void set_up_rotation(const std::vector<MotionSample>& samples, const CameraModel& camera,
                     const Vector2d& direction, const RotationHypothesis& near, Geometry geometry,
                     MotionScratch& scratch) {
    const PlaneGeometry plane(camera.mount);
    const Derotation derotated(plane, near.omega_rad, near.pitch_rad, geometry);
    const Vector2d one_px = one_pixel(camera);
    scratch.rotation_equations.clear();
    for (const MotionSample& s : samples) {
        const RayFlow travel = derotated(s.ray);
        const Vector2d e = plane.e(travel.at, direction);
        if (e.squaredNorm() < 1e-12) continue;
        const double weight = 1.0 / deviation_of_cross(e, s.ray.sigma);
        MotionScratch::RotationEquation row;
        row.turn = cross(e, plane.h(travel.at)) * weight;
        row.pitch = cross(e, PlaneGeometry::p(travel.at)) * weight;
        row.measured =
            cross(e, travel.flow) * weight + row.turn * near.omega_rad + row.pitch * near.pitch_rad;
        row.weight = 1.0;
        row.deviation_px = 1.0 / (weight * deviation_of_cross(e, one_px));
        row.at = s.ray.at;
        scratch.rotation_equations.push_back(row);
    }
    prepare_inlier_counts(scratch);
}

Consensus start_rotation(const std::vector<MotionSample>& samples, const CameraModel& camera,
                         const Vector2d& direction, const MotionPrediction& prediction,
                         const MotionParams& params, MotionScratch& scratch) {
    const RotationHypothesis predicted{prediction.omega_rad,
                                       params.model == MotionModel::YawPitch ? prediction.pitch_rad : 0.0};
    const Consensus continuing{predicted, support_of(scratch.inlier_counts, predicted, params.lambda_px),
                               true};
    if (outvotes_every_other_motion(continuing)) return continuing;
    const double background_rad = background(samples, camera, direction, scratch);
    return find_consensus(scratch, background_rad, prediction, params);
}

Rotation fit_rotation(const RotationHypothesis& start, const MotionParams& params, MotionScratch& scratch) {
    Rotation r;
    r.turn = start;
    for (int step = 0; step < biweight_steps; ++step) {
        r.noise_factor = noise_factor_about(r.turn, params.lambda_px, scratch);
        for (auto& row : scratch.rotation_equations)
            row.weight = biweight(residual(row, r.turn) / r.noise_factor);
        const double before_rad = r.turn.omega_rad;
        solve(scratch, params.model, r);
        if (std::abs(r.turn.omega_rad - before_rad) < settled_deviations * r.sigma_omega_rad) break;
    }
    r.support = support_of(scratch.inlier_counts, r.turn, params.lambda_px);
    return r;
}

}  // namespace flownav::motion
