#pragma once
#include "cycle.h"
#include "measure.h"

namespace flownav::pipeline {

/// Predicts the motion from the reference to the newest field.
motion::MotionPrediction predict(const Rates& rates, const Cycle& cycle, const Elapsed& elapsed);

/// The fields to compare, and what is known of the motion between them.
struct ComparedFields {
    const ReferenceImage& reference;
    const ReferenceImage& newest;
    const flow::BlockLayout& layout;
    const flow::BlockLayout& coarse_layout;  ///< every few blocks of `layout`, for searches
    const Rates& rates;
    const Cycle& cycle;
    double since_last_s = 0.0;  ///< since the last field that was compared
};

/// Measures flow and motion into `measured`, from the predicted motion; where little supports that, from the
/// best motion of a wide search. `trial` is working memory. Returns whether the motion is credible.
bool measure_motion(const ComparedFields& fields, const motion::MotionPrediction& prediction,
                    const MeasureContext& context, Measurement& measured, Measurement& trial);

}  // namespace flownav::pipeline
