#include "flownav/motion/estimate_motion.h"

#include "rotation.h"
#include "travel.h"

namespace flownav::motion {
namespace {

using Eigen::Vector2d;

constexpr int travel_rounds = 2;  // e depends on the direction of the travel, which the first round measures

Vector2d direction_of(const Vector2d& travel) {
    const double length = travel.norm();
    return length > 1e-6 ? Vector2d(travel / length) : Vector2d(1.0, 0.0);
}

}  // namespace

EgoMotion unmeasured_motion(const MotionPrediction& prediction) {
    EgoMotion m;
    m.omega_rad = prediction.omega_rad;
    m.pitch_rad = prediction.pitch_rad;
    m.chord_rad = prediction.chord_rad;
    m.forward_m = prediction.forward_m;
    return m;
}

MotionEstimate estimate_motion(const std::vector<MotionSample>& samples, const CameraModel& camera,
                               const MotionPrediction& prediction, const MotionParams& params,
                               MotionScratch& scratch) {
    MotionEstimate estimate;
    EgoMotion& m = estimate.motion;
    m = unmeasured_motion(prediction);
    if (samples.empty()) return estimate;
    RotationHypothesis turn{m.omega_rad, m.pitch_rad};
    for (int round = 0; round < travel_rounds; ++round) {
        const Vector2d direction =
            direction_of(camera_travel(camera.mount, m.forward_m, m.omega_rad, m.chord_rad));
        set_up_rotation(samples, camera, direction, turn, params.geometry, scratch);
        if (round == 0) {
            const Consensus start = start_rotation(samples, camera, direction, prediction, params, scratch);
            turn = start.turn;
            estimate.as_predicted = start.as_predicted;
        }
        const Rotation r = fit_rotation(turn, params, scratch);
        turn = r.turn;
        const Travel t = fit_travel(samples, camera, direction, r, params, scratch);
        m = unmeasured_motion(prediction);
        m.omega_rad = r.turn.omega_rad;
        m.pitch_rad = r.turn.pitch_rad;
        m.sigma_omega_rad = r.sigma_omega_rad;
        m.omega_measured = true;
        m.omega_source = MotionSource::Flow;
        m.inliers = r.support.vectors;
        m.ground_window = t.support;
        m.forward_measured = t.support > 0;
        if (m.forward_measured) {
            m.forward_source = MotionSource::Flow;
            m.forward_m = t.along_m * direction.x() + m.omega_rad * camera.mount.left_m;
            m.sigma_forward_m = t.sigma_m;
        }
        estimate.support_share = r.support.share();
        estimate.noise_factor = r.noise_factor;
    }
    return estimate;
}

}  // namespace flownav::motion
