#include "search.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "flownav/core/plane_geometry.h"

namespace flownav::pipeline {
namespace {

using Eigen::Vector2d;

constexpr double window_step_px = 12.0;  // windows overlap by 4 px
constexpr int pitch_steps = 1;           // up and down
constexpr int quarter = 4;

/// How many window steps are tried: turns to either side, travels forward.
struct Extent {
    int turns;
    int travels;
};
constexpr Extent full_extent{6, 4};
constexpr Extent quarter_extent{3, 3};
constexpr int travels_back = 1;

/// Turn that moves the image centre by one window step.
double turn_step_rad(const CameraModel& camera) {
    const PlaneGeometry plane(camera.mount);
    return window_step_px / camera.fx_px / plane.h({0.0, 0.0}).x();
}

/// Travel that moves the ground at the lower border by one window step, metres.
double travel_step_m(const ReferenceImage& held) {
    const CameraModel& camera = held.field.camera;
    const PlaneGeometry plane(camera.mount);
    const Vector2d at = held.mapper.ray({camera.width_px / 2.0, camera.height_px - 1.0});
    const Vector2d flow_per_m = plane.e(at) * plane.ground_inverse_depth(at);
    return window_step_px / std::max(1.0, std::abs(flow_per_m.y()) * camera.fy_px);
}

/// The best of the motions that were tried.
struct Trials {
    const ReferenceImage& reference;
    const ReferenceImage& newest;
    const flow::BlockLayout& layout;
    const MeasureContext& context;
    Measurement& m;
    motion::MotionPrediction best;
    int best_support = -1;

    void measure_from(const motion::MotionPrediction& start) {
        measure(reference, newest, layout, start, context, m);
        const EgoMotion& found = m.estimate.motion;
        const int support = found.inliers + found.ground_window;
        if (support <= best_support) return;
        best_support = support;
        best = {};
        best.omega_rad = found.omega_rad;
        best.pitch_rad = found.pitch_rad;
        best.forward_m = found.forward_m;
    }
    void slide_windows(const Extent& extent) {
        const double turn_rad = turn_step_rad(reference.field.camera);
        const double travel_m = travel_step_m(reference);
        for (int i = -extent.turns; i <= extent.turns; ++i)
            for (int k = 0; k <= extent.travels; ++k) measure_from({i * turn_rad, 0.0, k * travel_m});
    }
};

/// The mean of each 4 x 4 pixels, seen by a camera with pixels four times as large.
ReferenceImage quartered(const ReferenceImage& held) {
    const ImageView& from = held.field.image;
    const int width = from.width_px / quarter;
    const int height = from.height_px / quarter;
    auto pixels = std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(width) * height);
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            int sum = 0;
            for (int i = 0; i < quarter * quarter; ++i)
                sum += from.at(u * quarter + i % quarter, v * quarter + i / quarter);
            (*pixels)[static_cast<std::size_t>(v) * width + u] =
                static_cast<std::uint8_t>((sum + quarter * quarter / 2) / (quarter * quarter));
        }
    }
    ReferenceImage small = held;
    CameraModel& camera = small.field.camera;
    camera.width_px = width;
    camera.height_px = height;
    camera.fx_px /= quarter;
    camera.fy_px /= quarter;
    // Integer coordinates are the middles of pixels.
    camera.cx_px = (camera.cx_px + 0.5) / quarter - 0.5;
    camera.cy_px = (camera.cy_px + 0.5) / quarter - 0.5;
    small.field.image = {pixels->data(), width, height, width};
    small.field.owner = pixels;
    small.mapper = RayMapper(camera);
    return small;
}

/// The best motion between images of a quarter of the size.
motion::MotionPrediction search_quartered(const ReferenceImage& reference, const ReferenceImage& newest,
                                          std::size_t blocks, const MeasureContext& context) {
    const ReferenceImage small_reference = quartered(reference);
    const ReferenceImage small_newest = quartered(newest);
    flow::FlowParams params = context.params.flow;
    params.blocks = static_cast<int>(blocks);
    const flow::BlockLayout layout = flow::place_blocks(small_reference.mapper, params);
    Measurement m;
    Trials trials{small_reference, small_newest, layout, context, m, {}, -1};
    trials.slide_windows(quarter_extent);
    return trials.best;
}

}  // namespace

motion::MotionPrediction search_motion(const ReferenceImage& reference, const ReferenceImage& newest,
                                       const flow::BlockLayout& layout,
                                       const motion::MotionPrediction& prediction,
                                       const MeasureContext& context, Measurement& m) {
    Trials trials{reference, newest, layout, context, m, {}, -1};
    const double pitch_rad = window_step_px / reference.field.camera.fy_px;
    for (int i = -pitch_steps; i <= pitch_steps; ++i) {
        motion::MotionPrediction start = prediction;
        start.pitch_rad += i * pitch_rad;
        trials.measure_from(start);
    }
    trials.slide_windows(full_extent);
    trials.measure_from(search_quartered(reference, newest, layout.size(), context));
    return trials.best;
}

motion::MotionPrediction search_travel(const ReferenceImage& reference, const ReferenceImage& newest,
                                       const flow::BlockLayout& layout, const motion::MotionPrediction& known,
                                       const MeasureContext& context, Measurement& m) {
    motion::MotionPrediction best = known;
    int best_support = 0;
    const double travel_m = travel_step_m(reference);
    for (int k = -travels_back; k <= full_extent.travels; ++k) {
        motion::MotionPrediction start = known;
        start.forward_m = k * travel_m;
        measure(reference, newest, layout, start, context, m);
        const EgoMotion& found = m.estimate.motion;
        if (!found.forward_measured || found.ground_window <= best_support) continue;
        best_support = found.ground_window;
        best.forward_m = found.forward_m;
    }
    return best;
}

}  // namespace flownav::pipeline
