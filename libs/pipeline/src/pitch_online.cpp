#include "pitch_online.h"

#include <algorithm>
#include <cmath>

#include "flownav/math/units.h"

namespace flownav::pipeline {
namespace {

constexpr double gain_min = 0.1;
constexpr double variance_gain = 0.1;
constexpr double variance_min_rad2 = 0.003 * degree_rad * 0.003 * degree_rad;
constexpr int ground_vectors_min = 40;
constexpr double ground_share_min = 0.6;  // of the vectors where the near floor is expected
constexpr double noise_factor_max = 2.0;
constexpr double sigma_max_rad = 0.5 * degree_rad;
constexpr double innovation_max_rad = 1.0 * degree_rad;
constexpr double correction_max_rad = 5.0 * degree_rad;

}  // namespace

void PitchOnline::observe(const std::vector<motion::MotionSample>& samples, const CameraModel& camera,
                          const EgoMotion& motion, Geometry geometry) {
    if (!motion.forward_measured) return;
    rays_.clear();
    for (const motion::MotionSample& sample : samples) rays_.push_back(sample.ray);
    const motion::PitchPrior pitch_prior{std::sqrt(pitch_variance_rad2_),
                                         std::numeric_limits<double>::infinity()};
    const motion::PairFit fit = motion::fit_pair(rays_, camera, motion, geometry, pitch_prior, scratch_);
    const bool plain_floor = fit.equations.pairs > 0 && fit.ground_vectors >= ground_vectors_min &&
                             fit.ground_vectors >= ground_share_min * fit.near_vectors &&
                             fit.noise_factor <= noise_factor_max;
    if (plain_floor) cycle_ += fit.equations;
}

void PitchOnline::learn(const EgoMotion& motion) {
    const motion::PoseCorrection found = motion::solve(motion::select(cycle_, {true, false, false}));
    cycle_ = {};
    pitch_variance_rad2_ += variance_gain * (motion.pitch_rad * motion.pitch_rad - pitch_variance_rad2_);
    pitch_variance_rad2_ = std::max(pitch_variance_rad2_, variance_min_rad2);
    if (found.sigma_rad[0] > sigma_max_rad) return;
    const double gain = std::max(gain_min, 1.0 / ++cycles_);
    correction_rad_ += gain * std::clamp(found.correction_rad[0], -innovation_max_rad, innovation_max_rad);
    correction_rad_ = std::clamp(correction_rad_, -correction_max_rad, correction_max_rad);
}

}  // namespace flownav::pipeline
