#include "measure_motion.h"

#include <algorithm>
#include <cmath>

#include "search.h"

namespace flownav::pipeline {
namespace {

constexpr int inliers_min = 10;
constexpr double inlier_share = 0.5;        // of the confident vectors, or
constexpr double placed_share = 0.12;       // of the blocks must agree with a motion
constexpr double expected_share = 0.3;      // of the image's cells must agree with a motion as predicted,
constexpr double unexpected_share = 0.5;    // and with any other
constexpr double turn_change_radps2 = 2.0;  // of a robot, at the most
constexpr double hold_s = 0.5;              // a prediction is trusted for so long without a measurement
// Tolerance of a turn that another sensor tells.
constexpr double told_sigmas = 3.0;
constexpr double told_tolerance_rad = 0.003;

/// Direction of the chord of the running cycle that ends with heading `omega_rad`, from half of that: the
/// mean heading of its images, at constant speed. A robot that begins or ends a turn leaves the circle.
double chord_direction(const Cycle& cycle, double omega_rad) {
    double sum_rad = omega_rad / 2;
    for (const ImageOfCycle& image : cycle) sum_rad += image.motion.omega_rad;
    return sum_rad / static_cast<double>(cycle.size() + 1) - omega_rad / 2;
}

/// True when a measured motion can be the robot's. One that continues the last needs little support. Any
/// other may be an object that moves across the view: it must fill most of the view, and either the floor
/// agrees with it or the last motion is too old to be trusted.
bool credible(const Rates& rates, const Measurement& m, double since_last_s) {
    const motion::MotionEstimate& e = m.estimate;
    // A handful agrees by chance, unless it is most of the vectors.
    const int confident = static_cast<int>(m.samples.size());
    const double enough = std::min(inlier_share * confident, placed_share * m.placed);
    if (e.motion.inliers < std::max<double>(inliers_min, enough)) return false;
    const bool prediction_worthless = !rates.known || rates.held_s + since_last_s > hold_s;
    if (e.as_predicted && !prediction_worthless) return e.support_share >= expected_share;
    return e.support_share >= unexpected_share && (prediction_worthless || e.motion.forward_measured);
}

/// Searches the travel of a known rotation, when the near floor moves so much faster than predicted that no
/// window finds it. Only for the first image of a cycle, whose flow is the shortest. `measured` holds the
/// result, or stays as it was.
void search_lost_travel(const ComparedFields& f, const MeasureContext& context, Measurement& measured,
                        Measurement& trial) {
    if (measured.estimate.motion.forward_measured || !f.cycle.empty()) return;
    motion::MotionPrediction known;
    known.omega_rad = measured.estimate.motion.omega_rad;
    known.pitch_rad = measured.estimate.motion.pitch_rad;
    known.omega_tolerance_rad = turn_change_radps2 * f.since_last_s * f.since_last_s;
    known.forward_m = measured.estimate.motion.forward_m;
    known = search_travel(f.reference, f.newest, f.coarse_layout, known, context, trial);
    known.chord_rad = chord_direction(f.cycle, known.omega_rad);
    measure(f.reference, f.newest, f.layout, known, context, trial);
    if (trial.estimate.motion.forward_measured && credible(f.rates, trial, f.since_last_s))
        std::swap(trial, measured);
}

/// Predicts the turn that is told.
void look_at(const ToldValue& turn, const Cycle& cycle, motion::MotionPrediction& p) {
    p.omega_rad = turn.value;
    p.omega_tolerance_rad = told_sigmas * turn.sigma + told_tolerance_rad;
    p.chord_rad = chord_direction(cycle, p.omega_rad);
}

/// Measures from the best motion of a wide search. Returns whether that is credible; then `measured` holds
/// it.
bool search_lost_motion(const ComparedFields& f, const motion::MotionPrediction& prediction,
                        const MeasureContext& context, Measurement& measured, Measurement& trial) {
    motion::MotionPrediction found =
        search_motion(f.reference, f.newest, f.coarse_layout, prediction, context, trial);
    found.chord_rad = chord_direction(f.cycle, found.omega_rad);
    measure(f.reference, f.newest, f.layout, found, context, trial);
    trial.estimate.as_predicted =
        std::abs(trial.estimate.motion.omega_rad - prediction.omega_rad) <= prediction.omega_tolerance_rad;
    if (!credible(f.rates, trial, f.since_last_s)) return false;
    EgoMotion& motion = trial.estimate.motion;
    if (!motion.forward_measured)
        motion.forward_m = prediction.forward_m;  // the hypothesis is no measurement
    std::swap(trial, measured);
    return true;
}

/// Measures from the told motion into `measured`. Returns whether the result is credible.
bool measure_at_told(const ComparedFields& f, motion::MotionPrediction p, const MeasureContext& context,
                     Measurement& measured, Measurement& trial) {
    look_at(*f.told.turn, f.cycle, p);
    if (f.told.way) p.forward_m = f.told.way->value;
    measure(f.reference, f.newest, f.layout, p, context, trial);
    std::swap(trial, measured);
    return credible(f.rates, measured, f.since_last_s);
}

}  // namespace

motion::MotionPrediction predict(const Rates& rates, const Cycle& cycle, const Elapsed& elapsed,
                                 const ToldMotion& told) {
    motion::MotionPrediction p;
    p.omega_rad = rates.omega_radps * elapsed.last_s;
    p.forward_m = rates.v_mps * elapsed.reference_s;
    if (!cycle.empty()) {
        p.omega_rad += cycle.back().motion.omega_rad;
        p.pitch_rad = cycle.back().motion.pitch_rad;
    }
    p.chord_rad = chord_direction(cycle, p.omega_rad);
    const double unmeasured_s = rates.held_s + elapsed.last_s;
    if (rates.known) p.omega_tolerance_rad = turn_change_radps2 * unmeasured_s * unmeasured_s;
    if (told.turn && (told.turn->is_prior() || rates.flow_lost)) look_at(*told.turn, cycle, p);
    if (told.way && (told.way->is_prior() || rates.flow_lost_way)) p.forward_m = told.way->value;
    return p;
}

bool measure_motion(const ComparedFields& f, const motion::MotionPrediction& prediction,
                    const MeasureContext& context, Measurement& measured, Measurement& trial) {
    measure(f.reference, f.newest, f.layout, prediction, context, measured);
    if (credible(f.rates, measured, f.since_last_s)) {
        search_lost_travel(f, context, measured, trial);
        return true;
    }
    if (search_lost_motion(f, prediction, context, measured, trial)) return true;
    const bool told_otherwise = f.told.turn && f.told.turn->value != prediction.omega_rad;
    return told_otherwise && measure_at_told(f, prediction, context, measured, trial);
}

}  // namespace flownav::pipeline
