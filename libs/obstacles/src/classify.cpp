#include "flownav/obstacles/classify.h"

#include <cmath>

namespace flownav::obstacles {
namespace {

using Eigen::Vector2d;

/// Smallest travel-induced flow of the ground, in units of tau, at which a vector counts as evidence of
/// ground. At this flow an obstacle at 4/5 of the ground's depth would exceed tau.
constexpr double ground_evidence_tau = 4.0;
constexpr double depth_tolerance = 0.15;
constexpr double significance = 3.0;  // standard deviations by which an obstacle must exceed the ground

}  // namespace

ClassifierInput::ClassifierInput(const CameraModel& camera, const EgoMotion& motion,
                                 double noise_factor_of_image)
    : plane(camera.mount),
      displacement_m(camera_travel(camera.mount, motion.forward_m, motion.omega_rad, motion.chord_rad)),
      pixel(one_pixel(camera)),
      noise_factor(noise_factor_of_image),
      travel_error(motion.sigma_forward_m / std::max(displacement_m.norm(), 1e-9)) {}

Classification classify(const RayFlow& travel, const ClassifierInput& motion, const ObstacleParams& params) {
    const Vector2d e = motion.plane.e(travel.at, motion.displacement_m);  // S e of Eq. (3), in metres
    const Vector2d& d = travel.flow;
    Classification j;
    j.at = travel.at;
    const double length2 = e.squaredNorm();
    j.label = BlockLabel::Unjudged;
    if (length2 < 1e-18) return j;
    j.measured = true;
    j.drift = d;
    j.drift_sigma = motion.noise_factor * travel.sigma.maxCoeff();
    // Eq. (10), with the travel inside e
    j.inverse_depth = e.dot(d) / length2;
    j.sigma = motion.noise_factor * deviation_of_dot(e, travel.sigma) / length2;
    // Eq. (13), as inverse depths and then in pixels along e
    const double ground = motion.plane.ground_inverse_depth(travel.at);
    const double pixels = length2 / deviation_of_dot(e, motion.pixel);
    j.excess_px = (j.inverse_depth - ground) * pixels;
    // tau is widened by the uncertainty of the vector and of the travel.
    const double ground_px = ground * pixels;
    const double tau_px =
        std::max(params.tau_px, significance * j.sigma * pixels) + 2.0 * motion.travel_error * ground_px;
    // Eq. (11)
    j.across_px = std::abs(cross(e, d)) / deviation_of_cross(e, motion.pixel);
    if (j.across_px >= params.lambda_px || e.dot(d) <= 0.0) {
        j.label = BlockLabel::Eliminated;
    } else if (j.excess_px > tau_px) {
        j.label = BlockLabel::Unsupported;
    } else if (j.excess_px > -tau_px && ground_px > ground_evidence_tau * tau_px) {
        j.label = BlockLabel::Ground;
    }
    return j;
}

bool similar_depth(const Classification& p, const Classification& q) {
    const double difference = std::abs(p.inverse_depth - q.inverse_depth);
    return difference < depth_tolerance * std::max(p.inverse_depth, q.inverse_depth);
}

}  // namespace flownav::obstacles
