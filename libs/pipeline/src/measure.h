#pragma once
#include <vector>

#include "flownav/core/field.h"
#include "flownav/flow/block_layout.h"
#include "flownav/flow/matcher.h"
#include "flownav/motion/estimate_motion.h"
#include "flownav/pipeline/params.h"

namespace flownav::pipeline {

/// A field that is held, with the mapping of its own camera.
struct ReferenceImage {
    Field field;
    RayMapper mapper;
};

/// Flow and ego-motion between two fields, with all intermediate products; one entry a block. Reused from
/// field to field, so that nothing is allocated.
struct Measurement {
    std::vector<Eigen::Vector2d> predicted_px;
    std::vector<FlowVector> vectors;
    std::vector<RayFlow> rays;                  ///< of the vectors that passed sifting
    std::vector<motion::MotionSample> samples;  ///< the same, without gaps
    motion::MotionScratch scratch;
    motion::MotionEstimate estimate;
    int placed = 0;
};

/// Parameters and matcher of a measurement; both outlive it.
struct MeasureContext {
    const Params& params;
    const flow::Matcher& matcher;
};

/// True when a vector passes sifting.
bool is_confident(const FlowVector& vector, const flow::FlowParams& params);

/// Matches the blocks of a layout whose reference this is, with their windows where the prediction expects
/// the ground, and estimates the motion.
void measure(const ReferenceImage& reference, const ReferenceImage& newest, const flow::BlockLayout& layout,
             const motion::MotionPrediction& prediction, const MeasureContext& context, Measurement& m);

}  // namespace flownav::pipeline
