#pragma once
#include "cycle.h"
#include "measure.h"
#include "other_sensors.h"

namespace flownav::pipeline {

/// Predicts the motion from the reference to the newest field: by the rates, and by what is told of it as a
/// prior or, after the flow was lost, as a fallback.
motion::MotionPrediction predict(const Rates& rates, const Cycle& cycle, const Elapsed& elapsed,
                                 const ToldMotion& told);

/// The fields to compare, and what is known of the motion between them.
struct ComparedFields {
    const ReferenceImage& reference;
    const ReferenceImage& newest;
    const flow::BlockLayout& layout;
    const flow::BlockLayout& coarse_layout;  ///< every few blocks of `layout`, for searches
    const Rates& rates;
    const Cycle& cycle;
    double since_last_s = 0.0;  ///< since the last field that was compared
    const ToldMotion& told;     ///< by other sensors
};

/// Measures flow and motion into `measured`, from the predicted motion; where little supports that, from the
/// best motion of a wide search, then from the told motion. `trial` is working memory. Returns whether the
/// motion is credible. If not, and if a turn is told, `measured` has the vectors found at the told motion.
bool measure_motion(const ComparedFields& fields, const motion::MotionPrediction& prediction,
                    const MeasureContext& context, Measurement& measured, Measurement& trial);

}  // namespace flownav::pipeline
