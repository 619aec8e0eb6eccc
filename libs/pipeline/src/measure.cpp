#include "measure.h"

#include <algorithm>
#include <cmath>

#include "flownav/core/plane_geometry.h"

namespace flownav::pipeline {
namespace {

using Eigen::Vector2d;

constexpr double window_step_px = 12.0;  // windows overlap by 4 px
constexpr int turn_steps = 6;            // to either side
constexpr int travel_steps = 4;

/// The flow that the ground would show.
void predict_flow(const HeldField& reference, const HeldField& newest, const BlockLayout& layout,
                  const MotionPrediction& prediction, Measurement& m) {
    const CameraMount& mount = reference.field.camera.mount;
    const PlaneGeometry plane(mount);
    m.predicted_px.resize(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) {
        const Vector2d at = reference.mapper.ray(layout.centre_px[i]);
        const Vector2d flow = predicted_ground_flow(plane, mount, at, prediction);
        m.predicted_px[i] = newest.mapper.pixel(at + flow) - layout.centre_px[i];
    }
}

/// Maps what passed sifting to the normalised plane.
void collect(const HeldField& reference, const HeldField& newest, const BlockLayout& layout,
             const Params& params, Measurement& m) {
    m.rays.resize(layout.size());
    m.samples.clear();
    m.placed = 0;
    for (std::size_t i = 0; i < layout.size(); ++i) {
        m.placed += m.vectors[i].valid;
        if (!is_confident(m.vectors[i], params.flow)) continue;
        m.rays[i] = ray_flow(m.vectors[i], reference.mapper, newest.mapper, params.motion.geometry);
        m.samples.push_back({m.rays[i], layout.in_ground_window[i] != 0});
    }
}

/// Turn that moves the image centre by one window step.
double turn_step_rad(const CameraModel& camera) {
    const PlaneGeometry plane(camera.mount);
    return window_step_px / camera.fx_px / plane.h({0.0, 0.0}).x();
}

/// Travel that moves the ground at the lower border by one window step, metres.
double travel_step_m(const HeldField& held) {
    const CameraModel& camera = held.field.camera;
    const PlaneGeometry plane(camera.mount);
    const Vector2d at = held.mapper.ray({camera.width_px / 2.0, camera.height_px - 1.0});
    const Vector2d flow_per_m = plane.e(at) * plane.ground_inverse_depth(at);
    return window_step_px / std::max(1.0, std::abs(flow_per_m.y()) * camera.fy_px);
}

int support_of(const MotionEstimate& estimate) {
    return estimate.motion.inliers + estimate.motion.ground_window;
}

}  // namespace

bool is_confident(const FlowVector& vector, const FlowParams& params) {
    return vector.valid && vector.confidence >= params.confidence_min;
}

void measure(const HeldField& reference, const HeldField& newest, const BlockLayout& layout,
             const MotionPrediction& prediction, const MeasureContext& context, Measurement& m) {
    predict_flow(reference, newest, layout, prediction, m);
    context.matcher(reference.field.image, newest.field.image, layout, m.predicted_px, m.vectors);
    collect(reference, newest, layout, context.params, m);
    m.estimate =
        estimate_motion(m.samples, reference.field.camera, prediction, context.params.motion, m.scratch);
}

MotionPrediction search_motion(const HeldField& reference, const HeldField& newest, const BlockLayout& layout,
                               const MeasureContext& context, Measurement& m) {
    const double turn_rad = turn_step_rad(reference.field.camera);
    const double travel_m = travel_step_m(reference);
    MotionPrediction best;
    int best_support = -1;
    for (int i = -turn_steps; i <= turn_steps; ++i) {
        for (int k = 0; k <= travel_steps; ++k) {
            measure(reference, newest, layout, {i * turn_rad, 0.0, k * travel_m}, context, m);
            if (support_of(m.estimate) <= best_support) continue;
            best_support = support_of(m.estimate);
            best = {m.estimate.motion.omega_rad, 0.0, m.estimate.motion.forward_m};
        }
    }
    return best;
}

}  // namespace flownav::pipeline
