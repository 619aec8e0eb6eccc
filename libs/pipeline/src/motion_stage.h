#pragma once
#include "state.h"

namespace flownav::pipeline {

/// What the rates say of the motion from the reference to the newest field.
motion::MotionPrediction predict(const State::Impl& s, double since_last_s);

/// Measures with the predicted motion; where that finds little support, with the best of a wide search.
/// False when no motion is credible.
bool measure_newest(State::Impl& s, const motion::MotionPrediction& prediction, double since_last_s);

/// Takes the measured motion, or the prediction where there is none to trust.
void accept_motion(State::Impl& s, bool is_credible, const motion::MotionPrediction& prediction,
                   double since_last_s);

/// Rates and odometry from the motion since the reference; whether the cycle ends.
void publish_motion(State::Impl& s, double since_last_s);

/// A field that shows nothing: the rates carry the odometry on for RateParams::carry_max_s, the reference
/// stays. `since_picture_s`, `since_field_s`: since the last field that was compared, and since the last one.
void carry_over(State::Impl& s, double since_picture_s, double since_field_s);

}  // namespace flownav::pipeline
