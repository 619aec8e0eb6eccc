#pragma once
#include "measure.h"

namespace flownav::pipeline {

/// Finds a motion that is far from the predicted one: pitches about the prediction, then turns and speeds by
/// windows slid along h and along e, on the images and on images of a quarter of their size, where a window
/// reaches four times as far. Returns the motion with the most support among the blocks of `layout`, a few
/// of those that are measured otherwise; m holds the last trial afterwards. The quarter images are made
/// anew: a search allocates, following a motion does not.
motion::MotionPrediction search_motion(const ReferenceImage& reference, const ReferenceImage& newest,
                                       const flow::BlockLayout& layout,
                                       const motion::MotionPrediction& prediction,
                                       const MeasureContext& context, Measurement& m);

/// Finds a travel that is far from the predicted one, for a rotation that is known: by windows slid along e.
/// Returns `known` with the travel that most of the floor agrees with, or with its own where none is found.
motion::MotionPrediction search_travel(const ReferenceImage& reference, const ReferenceImage& newest,
                                       const flow::BlockLayout& layout, const motion::MotionPrediction& known,
                                       const MeasureContext& context, Measurement& m);

}  // namespace flownav::pipeline
