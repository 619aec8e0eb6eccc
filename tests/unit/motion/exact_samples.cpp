#include "exact_samples.h"

#include "flownav/flow/block_layout.h"
#include "flownav/math/units.h"

namespace flownav::testing {

Pair drive(const CameraModel& camera, double v_mps, double omega_degps, double images, const World& world,
           const Pose2& start) {
    const Pose2 motion = along_arc(omega_degps * degree_rad * images * image_s, v_mps * images * image_s);
    const View from{camera, start, 0.0};
    const View to{camera, compose(start, motion), 0.0};
    return {world, from, to, exact_motion(from, to)};
}

std::vector<FlowVector> exact_vectors(const Pair& pair) {
    std::vector<FlowVector> vectors;
    for (const Eigen::Vector2d& at_px : flow::place_blocks(RayMapper(pair.from.camera), {}).centre_px) {
        const auto truth = exact_flow(pair.world, pair.from, pair.to, at_px);
        if (!truth || !truth->inside || truth->occluded) continue;
        vectors.push_back({at_px, truth->flow_px, {0.3, 0.3}, 1.0, true});
    }
    return vectors;
}

std::vector<motion::MotionSample> samples_of(const Pair& pair, const std::vector<FlowVector>& vectors,
                                             Geometry geometry) {
    const RayMapper from(pair.from.camera);
    const RayMapper to(pair.to.camera);
    std::vector<motion::MotionSample> samples;
    samples.reserve(vectors.size());
    for (const FlowVector& v : vectors)
        samples.push_back(
            {motion::ray_flow(v, from, to, geometry), in_ground_window(v.at_px, pair.from.camera)});
    return samples;
}

motion::MotionEstimate estimate(const Pair& pair, const std::vector<motion::MotionSample>& samples,
                                const motion::MotionParams& params) {
    motion::MotionPrediction rough;
    rough.omega_rad = 0.8 * pair.truth.omega_rad;
    rough.forward_m = 0.8 * pair.truth.forward_m;
    motion::MotionScratch scratch;
    return motion::estimate_motion(samples, pair.from.camera, rough, params, scratch);
}

}  // namespace flownav::testing
