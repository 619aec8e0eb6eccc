#include "motion_stage.h"

#include <algorithm>
#include <cmath>

#include "rate_control.h"
#include "search.h"

namespace flownav::pipeline {
namespace {

using Impl = State::Impl;

constexpr int confident_min = 12;  // vectors; with fewer there is no texture to speak of
constexpr int inliers_min = 10;
constexpr double inlier_share = 0.5;        // of the confident vectors, or
constexpr double placed_share = 0.12;       // of the blocks must agree with a motion
constexpr double expected_share = 0.3;      // of the image's cells must agree with a motion as predicted,
constexpr double unexpected_share = 0.5;    // and with any other
constexpr double turn_change_radps2 = 2.0;  // of a robot, at the most
constexpr double hold_s = 0.5;              // a prediction outlives so long whatever covers the view
constexpr int failures_max = 2;             // in a row; then a newer reference is better
constexpr int blind_cycle_images = 3;       // while the speed, and with it the flow to come, is unknown
constexpr double speed_drift_per_s = 0.3;   // relative; how fast a speed that is carried over loses its worth

double seconds_since_reference(const Impl& s) {
    return s.newest.field.timestamp_s - s.reference.field.timestamp_s;
}

/// Direction of the chord of the running cycle that ends with heading `omega_rad`, from half of that: the
/// mean heading of its images, at constant speed. A robot that begins or ends a turn does not move on a
/// circle.
double chord_direction(const std::vector<ImageOfCycle>& cycle, double omega_rad) {
    double sum_rad = omega_rad / 2;
    for (const ImageOfCycle& image : cycle) sum_rad += image.motion.omega_rad;
    return sum_rad / static_cast<double>(cycle.size() + 1) - omega_rad / 2;
}

/// True when a measured motion can be the robot's. One that continues the last needs little support. Another
/// may be something that moves across the view: it must fill most of it and the floor before the robot must
/// move along, or the last motion must be long gone.
bool credible(const Impl& s, const Measurement& m, double since_last_s) {
    const motion::MotionEstimate& e = m.estimate;
    // A handful agrees by chance, unless it is most of what there is.
    const int confident = static_cast<int>(m.samples.size());
    const double enough = std::min(inlier_share * confident, placed_share * m.placed);
    if (e.motion.inliers < std::max<double>(inliers_min, enough)) return false;
    const bool prediction_worthless = !s.rates.known || s.rates.held_s + since_last_s > hold_s;
    if (e.as_predicted && !prediction_worthless) return e.support_share >= expected_share;
    return e.support_share >= unexpected_share && (prediction_worthless || e.motion.forward_measured);
}

/// Counts how the comparisons with the reference go.
void note_comparison(Impl& s) {
    const bool ok = s.step.status == FieldStatus::Ok;
    s.failures = ok ? 0 : s.failures + 1;
    if (ok && s.step.image_of_cycle == 1) s.first_inliers = s.step.motion.inliers;
}

/// True when a cycle has to end before its time: the view has changed so much that few of its first vectors
/// are left, or two images could not be compared with the reference.
bool reference_degraded(const Impl& s) {
    const bool ok = s.step.status == FieldStatus::Ok;
    return s.failures >= failures_max || (ok && 2 * s.step.motion.inliers < s.first_inliers);
}

/// The part of an interval during which a motion is still carried over that was not measured for `held_s`
/// before it.
double carried_part_s(const Impl& s, double held_s, double interval_s) {
    return std::clamp(s.params.rate.carry_max_s - held_s, 0.0, interval_s);
}

/// The parts of an interval during which turn and way are still carried over; all of it when measured.
struct CarriedParts {
    double turn_s = 0.0;
    double way_s = 0.0;
};

CarriedParts carried_parts(const Impl& s, bool turn_measured, bool way_measured, double interval_s) {
    return {turn_measured ? interval_s : carried_part_s(s, s.rates.held_s, interval_s),
            way_measured ? interval_s : carried_part_s(s, s.rates.v_held_s, interval_s)};
}

/// The motion since the reference as the odometry counts it: as measured or predicted, but what is not
/// measured does not go on for ever.
EgoMotion counted_motion(const Impl& s, const CarriedParts& parts, double interval_s) {
    EgoMotion counted = s.step.motion;
    if (parts.turn_s < interval_s)
        counted.omega_rad = s.counted.omega_rad + s.rates.omega_radps * parts.turn_s;
    if (parts.way_s < interval_s) counted.forward_m = s.counted.forward_m + s.rates.v_mps * parts.way_s;
    return counted;
}

/// A rotation can be seen far away while the near floor moves so much faster than predicted that no window
/// finds it, and then goes on not to be found. Looks for it with the first image of a cycle, whose flow is
/// the shortest; s.measured holds it afterwards, or what it held before.
void search_lost_travel(Impl& s, const MeasureContext& context, double since_last_s) {
    if (s.measured.estimate.motion.forward_measured || !s.cycle.empty()) return;
    motion::MotionPrediction known;
    known.omega_rad = s.measured.estimate.motion.omega_rad;
    known.pitch_rad = s.measured.estimate.motion.pitch_rad;
    known.omega_tolerance_rad = turn_change_radps2 * since_last_s * since_last_s;
    known.forward_m = s.measured.estimate.motion.forward_m;
    known = search_travel(s.reference, s.newest, s.coarse_layout, known, context, s.trial);
    known.chord_rad = chord_direction(s.cycle, known.omega_rad);
    measure(s.reference, s.newest, s.layout, known, context, s.trial);
    if (s.trial.estimate.motion.forward_measured && credible(s, s.trial, since_last_s))
        std::swap(s.trial, s.measured);
}

}  // namespace

motion::MotionPrediction predict(const Impl& s, double since_last_s) {
    motion::MotionPrediction p;
    p.omega_rad = s.rates.omega_radps * since_last_s;
    p.forward_m = s.rates.v_mps * seconds_since_reference(s);
    if (!s.cycle.empty()) {
        p.omega_rad += s.cycle.back().motion.omega_rad;
        p.pitch_rad = s.cycle.back().motion.pitch_rad;
    }
    p.chord_rad = chord_direction(s.cycle, p.omega_rad);
    const double unmeasured_s = s.rates.held_s + since_last_s;
    if (s.rates.known) p.omega_tolerance_rad = turn_change_radps2 * unmeasured_s * unmeasured_s;
    return p;
}

bool measure_newest(Impl& s, const motion::MotionPrediction& prediction, double since_last_s) {
    const MeasureContext context{s.params, s.matcher};
    measure(s.reference, s.newest, s.layout, prediction, context, s.measured);
    if (credible(s, s.measured, since_last_s)) {
        search_lost_travel(s, context, since_last_s);
        return true;
    }
    motion::MotionPrediction found =
        search_motion(s.reference, s.newest, s.coarse_layout, prediction, context, s.trial);
    found.chord_rad = chord_direction(s.cycle, found.omega_rad);
    measure(s.reference, s.newest, s.layout, found, context, s.trial);
    s.trial.estimate.as_predicted =
        std::abs(s.trial.estimate.motion.omega_rad - prediction.omega_rad) <= prediction.omega_tolerance_rad;
    if (!credible(s, s.trial, since_last_s)) return false;
    EgoMotion& trial = s.trial.estimate.motion;
    if (!trial.forward_measured) trial.forward_m = prediction.forward_m;  // the hypothesis is no measurement
    std::swap(s.trial, s.measured);
    return true;
}

void accept_motion(Impl& s, bool is_credible, const motion::MotionPrediction& prediction,
                   double since_last_s) {
    Step& out = s.step;
    const bool textured = static_cast<int>(s.measured.samples.size()) >= confident_min;
    out.status = !textured ? FieldStatus::NoTexture : is_credible ? FieldStatus::Ok : FieldStatus::Lost;
    const bool ok = out.status == FieldStatus::Ok;
    const EgoMotion& measured = s.measured.estimate.motion;
    out.motion = ok ? measured : motion::unmeasured_motion(prediction);
    s.rates.known |= ok;
    s.rates.v_known |= out.motion.forward_measured;
    if (out.motion.forward_measured) {
        s.rates.sigma_v_relative =
            out.motion.sigma_forward_m / std::max(std::abs(out.motion.forward_m), 1e-6);
    } else {
        s.rates.sigma_v_relative = std::min(1.0, s.rates.sigma_v_relative + speed_drift_per_s * since_last_s);
        out.motion.sigma_forward_m = s.rates.sigma_v_relative * std::abs(out.motion.forward_m);
    }
    out.counts.inliers = measured.inliers;
    out.counts.ground_window = measured.ground_window;
    const Derotation derotation(PlaneGeometry(s.reference.field.camera.mount), out.motion.omega_rad,
                                out.motion.pitch_rad, s.params.motion.geometry);
    const obstacles::ClassifierInput judged(s.reference.field.camera, out.motion,
                                            s.measured.estimate.noise_factor);
    s.cycle.push_back({out.motion, derotation, judged, pose_half_way(out.motion)});
}

void publish_motion(Impl& s, double since_last_s) {
    Step& out = s.step;
    const bool ok = out.status == FieldStatus::Ok;
    const CarriedParts parts = carried_parts(s, ok, out.motion.forward_measured, since_last_s);
    s.counted = counted_motion(s, parts, since_last_s);
    out.T_start_robot = compose(s.T_start_reference, pose_after(s.counted));
    s.rates.held_s = ok ? 0.0 : s.rates.held_s + since_last_s;
    s.rates.v_held_s = out.motion.forward_measured ? 0.0 : s.rates.v_held_s + since_last_s;

    // The next field is predicted as if the motion went on: that finds it again.
    const EgoMotion& before = s.last_measured.motion;
    const double since_measured_s = out.timestamp_s - s.last_measured.timestamp_s;
    s.rates.omega_radps = (out.motion.omega_rad - before.omega_rad) / since_measured_s;
    s.rates.v_mps = out.motion.forward_m / seconds_since_reference(s);
    out.omega_radps = parts.turn_s > 0.0 ? s.rates.omega_radps : 0.0;
    out.v_mps = parts.way_s > 0.0 ? s.rates.v_mps : 0.0;
    out.pitch_rate_radps = (out.motion.pitch_rad - before.pitch_rad) / since_measured_s;

    out.cycle_images = s.rates.v_known ? plan_cycle(s.params.rate, s.rates.v_mps * since_last_s, since_last_s)
                                       : blind_cycle_images;
    const bool complete = out.image_of_cycle >= out.cycle_images && ok;
    note_comparison(s);
    out.end_of_cycle =
        reference_degraded(s) || complete;  // an image that could not be compared is no good reference
    out.v_measured = out.motion.forward_measured && out.end_of_cycle;
    if (ok) s.last_measured = {out.motion, out.timestamp_s};
}

void carry_over(Impl& s, double since_picture_s, double since_field_s) {
    Step& out = s.step;
    out.status = FieldStatus::BadField;
    const double before_s = since_picture_s - since_field_s;
    const double turn_s = carried_part_s(s, s.rates.held_s + before_s, since_field_s);
    const double way_s = carried_part_s(s, s.rates.v_held_s + before_s, since_field_s);
    const bool turns = turn_s > 0.0 || since_field_s == 0.0;
    const bool drives = way_s > 0.0 || since_field_s == 0.0;
    out.omega_radps = turns ? s.rates.omega_radps : 0.0;
    out.v_mps = drives ? s.rates.v_mps : 0.0;
    out.T_start_robot =
        compose(out.T_start_robot, along_arc(s.rates.omega_radps * turn_s, s.rates.v_mps * way_s));
}

}  // namespace flownav::pipeline
