#include "measure.h"

#include <algorithm>
#include <cmath>

#include "flownav/core/plane_geometry.h"

namespace flownav::pipeline {
namespace {

using Eigen::Vector2d;

/// Predicts the flow of the ground, one vector a block.
void predict_flow(const ReferenceImage& reference, const ReferenceImage& newest,
                  const flow::BlockLayout& layout, const motion::MotionPrediction& prediction,
                  Measurement& m) {
    const motion::GroundFlow ground_flow(reference.field.camera.mount, prediction);
    m.predicted_px.resize(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) {
        const Vector2d& at = layout.centre[i];
        m.predicted_px[i] = newest.mapper.pixel(at + ground_flow(at)) - layout.centre_px[i];
    }
}

/// Maps the vectors that pass sifting to the normalised plane.
void collect(const ReferenceImage& reference, const ReferenceImage& newest, const flow::BlockLayout& layout,
             const Params& params, Measurement& m) {
    m.rays.resize(layout.size());
    m.samples.clear();
    m.placed = 0;
    for (std::size_t i = 0; i < layout.size(); ++i) {
        m.placed += m.vectors[i].valid;
        if (!is_confident(m.vectors[i], params.flow)) continue;
        m.rays[i] = motion::ray_flow(m.vectors[i], layout.centre[i], reference.mapper, newest.mapper,
                                     params.motion.geometry);
        m.samples.push_back({m.rays[i], layout.in_ground_window[i] != 0});
    }
}

}  // namespace

bool is_confident(const FlowVector& vector, const flow::FlowParams& params) {
    return vector.valid && vector.confidence >= params.confidence_min;
}

void measure(const ReferenceImage& reference, const ReferenceImage& newest, const flow::BlockLayout& layout,
             const motion::MotionPrediction& prediction, const MeasureContext& context, Measurement& m) {
    predict_flow(reference, newest, layout, prediction, m);
    context.matcher(reference.field.image, newest.field.image, layout, m.predicted_px, m.vectors);
    collect(reference, newest, layout, context.params, m);
    m.estimate = motion::estimate_motion(m.samples, reference.field.camera, prediction, context.params.motion,
                                         m.scratch);
}

}  // namespace flownav::pipeline
