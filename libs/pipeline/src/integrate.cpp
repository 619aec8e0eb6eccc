#include "integrate.h"

#include <algorithm>
#include <cmath>

namespace flownav::pipeline {
namespace {

constexpr int confident_min = 12;  // vectors; fewer mean no texture
// Changes of a robot's motion between two fields, at the most: per second, and beyond that by errors of the
// flow.
constexpr double accel_max_mps2 = 15.0;
constexpr double alpha_max_radps2 = 60.0;
constexpr double v_floor_mps = 0.3;
constexpr double omega_floor_radps = 0.5;
constexpr double change_share = 0.3;
constexpr double speed_drift_per_s = 0.3;  // relative; growth of the error of a speed that is carried over

/// The part of an interval during which a motion is still carried over that was not measured for `held_s`
/// before it.
double carried_part_s(double held_s, double interval_s, double carry_max_s) {
    return std::clamp(carry_max_s - held_s, 0.0, interval_s);
}

/// The parts of an interval during which turn and way are still carried over; all of it when measured.
struct CarriedParts {
    double turn_s = 0.0;
    double way_s = 0.0;
};

CarriedParts carried_parts(const AcceptedMotion& accepted, const Rates& rates, double interval_s,
                           double carry_max_s) {
    const bool turn_measured = accepted.motion.omega_measured;
    const bool way_measured = accepted.motion.forward_measured;
    return {turn_measured ? interval_s : carried_part_s(rates.held_s, interval_s, carry_max_s),
            way_measured ? interval_s : carried_part_s(rates.v_held_s, interval_s, carry_max_s)};
}

/// The motion since the reference as the odometry counts it: each part as accepted, or carried over.
EgoMotion counted_motion(const EgoMotion& motion, const EgoMotion& before, const Rates& rates,
                         const CarriedParts& parts, double interval_s) {
    EgoMotion counted = motion;
    if (parts.turn_s < interval_s) counted.omega_rad = before.omega_rad + rates.omega_radps * parts.turn_s;
    if (parts.way_s < interval_s) counted.forward_m = before.forward_m + rates.v_mps * parts.way_s;
    return counted;
}

/// The value, kept within what a robot can change since `before_s`: a wrong time stamp makes any speed.
double reachable(double value, double before, double change_per_s, double before_s, double floor) {
    const double most = change_per_s * before_s + std::max(floor, change_share * std::abs(before));
    return std::clamp(value, before - most, before + most);
}

/// The rates to predict from.
void limit_to_a_robot(Rates& rates, const Rates& before, double since_last_s) {
    if (before.known)
        rates.omega_radps = reachable(rates.omega_radps, before.omega_radps, alpha_max_radps2,
                                      before.held_s + since_last_s, omega_floor_radps);
    if (before.v_known)
        rates.v_mps =
            reachable(rates.v_mps, before.v_mps, accel_max_mps2, before.v_held_s + since_last_s, v_floor_mps);
}

}  // namespace

AcceptedMotion estimate(const Measurement& measured, bool is_credible,
                        const motion::MotionPrediction& prediction, const ToldMotion& told,
                        double sigma_v_relative, double since_last_s) {
    AcceptedMotion out;
    const bool textured = static_cast<int>(measured.samples.size()) >= confident_min;
    out.status = !textured ? FieldStatus::NoTexture : is_credible ? FieldStatus::Ok : FieldStatus::Lost;
    out.motion =
        out.status == FieldStatus::Ok ? measured.estimate.motion : motion::unmeasured_motion(prediction);
    out.motion = completed(averaged(out.motion, told), told);
    if (out.motion.forward_measured) {
        out.sigma_v_relative = out.motion.sigma_forward_m / std::max(std::abs(out.motion.forward_m), 1e-6);
    } else {
        out.sigma_v_relative = std::min(1.0, sigma_v_relative + speed_drift_per_s * since_last_s);
        out.motion.sigma_forward_m = out.sigma_v_relative * std::abs(out.motion.forward_m);
    }
    return out;
}

ImageOfCycle image_of_cycle(const CameraModel& reference, const EgoMotion& motion, double noise_factor,
                            Geometry geometry) {
    return {motion, Derotation(PlaneGeometry(reference.mount), motion.omega_rad, motion.pitch_rad, geometry),
            obstacles::ClassifierInput(reference, motion, noise_factor), pose_half_way(motion)};
}

IntegratedMotion integrate(const AcceptedMotion& accepted, const Odometry& odometry, const Rates& before,
                           double timestamp_s, const Elapsed& elapsed, double carry_max_s) {
    const EgoMotion& motion = accepted.motion;
    const CarriedParts parts = carried_parts(accepted, before, elapsed.last_s, carry_max_s);
    IntegratedMotion out;
    out.counted = counted_motion(motion, odometry.counted, before, parts, elapsed.last_s);
    out.T_start_robot = compose(odometry.T_start_reference, pose_after(out.counted));

    out.rates.known = before.known || motion.omega_measured;
    out.rates.v_known = before.v_known || motion.forward_measured;
    out.rates.sigma_v_relative = accepted.sigma_v_relative;
    out.rates.held_s = motion.omega_measured ? 0.0 : before.held_s + elapsed.last_s;
    out.rates.v_held_s = motion.forward_measured ? 0.0 : before.v_held_s + elapsed.last_s;
    out.rates.flow_lost = out.rates.known && accepted.status != FieldStatus::Ok;
    out.rates.flow_lost_way = out.rates.v_known && motion.forward_source != MotionSource::Flow;
    // The next field is predicted as if the motion went on.
    const double since_measured_s = timestamp_s - odometry.measured_s;
    out.rates.omega_radps = (motion.omega_rad - odometry.measured.omega_rad) / since_measured_s;
    out.rates.v_mps = motion.forward_m / elapsed.reference_s;

    out.omega_radps = parts.turn_s > 0.0 ? out.rates.omega_radps : 0.0;
    out.v_mps = parts.way_s > 0.0 ? out.rates.v_mps : 0.0;
    limit_to_a_robot(out.rates, before, elapsed.last_s);
    out.pitch_rate_radps = (motion.pitch_rad - odometry.measured.pitch_rad) / since_measured_s;
    return out;
}

CarriedMotion carry_over(const Rates& rates, double since_picture_s, double since_field_s,
                         double carry_max_s) {
    const double before_s = since_picture_s - since_field_s;
    const double turn_s = carried_part_s(rates.held_s + before_s, since_field_s, carry_max_s);
    const double way_s = carried_part_s(rates.v_held_s + before_s, since_field_s, carry_max_s);
    const bool turns = turn_s > 0.0 || since_field_s == 0.0;
    const bool drives = way_s > 0.0 || since_field_s == 0.0;
    return {turns ? rates.omega_radps : 0.0, drives ? rates.v_mps : 0.0,
            along_arc(rates.omega_radps * turn_s, rates.v_mps * way_s), EgoMotion{}};
}

CarriedMotion told_instead(const CarriedMotion& carried, const ToldMotion& step,
                           const ToldMotion& since_reference, double since_field_s) {
    CarriedMotion out = carried;
    if (since_field_s <= 0.0 || (!step.turn && !step.way)) return out;
    out.told = completed(EgoMotion{}, since_reference);
    const double turn_rad = step.turn ? step.turn->value : carried.T_before_now.yaw_rad;
    const double way_m = step.way ? step.way->value : motion::chord_m(carried.T_before_now);
    if (step.turn) out.omega_radps = turn_rad / since_field_s;
    if (step.way) out.v_mps = way_m / since_field_s;
    out.T_before_now = along_arc(turn_rad, way_m, step.turn && step.way ? step.chord_rad : 0.0);
    return out;
}

}  // namespace flownav::pipeline
