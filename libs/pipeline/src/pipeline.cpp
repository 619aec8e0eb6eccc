#include "flownav/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "field_quality.h"
#include "flownav/obstacles/virtual_scan.h"
#include "motion_stage.h"
#include "obstacle_stage.h"
#include "state.h"

namespace flownav::pipeline {
namespace {

using Eigen::Vector2d;
using Impl = State::Impl;

constexpr std::size_t coarse_step = 3;  // the search looks at every third block

/// When the last field came that could be compared: a bad field in between measured nothing.
double last_picture_s(const Impl& s) {
    return (s.cycle.empty() ? s.reference : s.newest).field.timestamp_s;
}

void aim_layouts(Impl& s) {
    flow::set_reference(s.layout, s.reference.mapper);
    flow::set_reference(s.coarse_layout, s.reference.mapper);
}

/// The newest field becomes the reference of a new cycle.
void begin_cycle(Impl& s) {
    std::swap(s.reference, s.newest);
    s.cycle.clear();
    s.has_reference = true;
    s.failures = 0;
    s.counted = {};
    s.last_measured = {EgoMotion{}, s.reference.field.timestamp_s};
    s.T_start_reference = s.step.T_start_robot;
    aim_layouts(s);
}

/// The first comparison of a cycle: what the last cycle measured is over.
void forget_last_cycle(Impl& s) {
    for (BlockRecord& block : s.step.blocks) block.image_of_cycle = 0;
}

void new_layout(Impl& s) {
    s.layout = flow::place_blocks(s.newest.mapper, s.params.flow);
    s.coarse_layout = flow::every_nth(s.layout, coarse_step);
    s.judgements.resize(s.layout.size());
    s.moved_before.assign(s.layout.size(), 0);
    s.step.blocks.assign(s.layout.size(), {});
    s.step.scan = obstacles::scan_layout(s.newest.mapper, s.params.obstacles);
}

/// What is learnt of the pitch is used from the next cycle on, by its reference and all that is compared with
/// it.
void correct_pitch(Impl& s, ReferenceImage& held) {
    s.step.pitch_correction_rad = s.pitch.correction_rad();
    if (s.pitch.correction_rad() == 0.0) return;
    held.field.camera.mount.pitch_rad = s.camera.mount.pitch_rad + s.pitch.correction_rad();
    held.mapper = RayMapper(held.field.camera);
}

/// Images of the second half of a cycle, so that vectors of the same block end anywhere in a pixel.
void observe_pitch(Impl& s) {
    if (!s.params.pitch_online || s.step.status != FieldStatus::Ok) return;
    if (2 * s.step.image_of_cycle < s.step.cycle_images) return;
    s.pitch.observe(s.measured.samples, s.reference.field.camera, s.step.motion, s.params.motion.geometry);
}

void learn_pitch(Impl& s) {
    if (!s.params.pitch_online) return;
    s.pitch.learn(s.step.motion);
    const double in_use_rad = s.step.pitch_correction_rad;
    correct_pitch(s, s.reference);
    aim_layouts(s);
    s.step.pitch_correction_rad = in_use_rad;
}

/// A new chain: nothing before this field can be compared with it.
void restart(Impl& s, bool new_camera) {
    if (new_camera) new_layout(s);
    if (new_camera) s.camera = s.newest.field.camera;
    s.step.restarted = s.has_reference;
    s.step.status = FieldStatus::Waiting;
    s.rates = {};
    begin_cycle(s);
}

/// Enters the vectors into the block records; a block without a good one keeps the last of the cycle. Those
/// of an image whose motion is not known say nothing.
void record_vectors(Impl& s, bool is_credible) {
    const PlaneGeometry plane(s.reference.field.camera.mount);
    s.step.counts.placed = s.measured.placed;
    s.step.counts.confident = static_cast<int>(s.measured.samples.size());
    for (std::size_t i = 0; i < s.layout.size(); ++i) {
        BlockRecord& block = s.step.blocks[i];
        const FlowVector& vector = s.measured.vectors[i];
        block.in_ground_window = s.layout.in_ground_window[i] != 0;
        block.predicted_px = s.measured.predicted_px[i];
        block.fresh = is_credible && is_confident(vector, s.params.flow);
        if (!block.fresh && block.image_of_cycle > 0) continue;
        block.vector = vector;
        block.ray = block.fresh ? s.measured.rays[i] : RayFlow{};
        block.label = block.fresh    ? BlockLabel::Unjudged
                      : vector.valid ? BlockLabel::Sifted
                                     : BlockLabel::Unplaced;
        block.image_of_cycle = block.fresh ? s.step.image_of_cycle : 0;
        block.omega_rad = block.fresh ? motion::omega_of(block.ray, plane, {1.0, 0.0}) : 0.0;
    }
}

void clear_outputs(Step& out) {
    out.restarted = out.end_of_cycle = out.v_measured = false;
    out.image_of_cycle = 0;
    out.omega_radps = out.pitch_rate_radps = out.v_mps = 0.0;
    out.motion = EgoMotion{};
    out.counts = BlockCounts{};
    out.obstacles.clear();
    out.ground.clear();
    for (BlockRecord& block : out.blocks) block.fresh = false;
}

/// Enters time and fault of a field; returns the time since the field before.
double begin_step(Impl& s, const Field& field, FieldFault fault) {
    s.step.fault = fault;
    ++s.step.faults[static_cast<std::size_t>(fault)];
    if (fault == FieldFault::TimeNotRising) {
        s.step.timestamp_s = std::isfinite(field.timestamp_s) ? field.timestamp_s : s.newest_s.value_or(0.0);
        return 0.0;
    }
    const double since_field_s = s.newest_s ? field.timestamp_s - *s.newest_s : 0.0;
    s.newest_s = s.step.timestamp_s = field.timestamp_s;
    return since_field_s;
}

/// Compares a field with the reference.
void compare(Impl& s, double since_last_s) {
    if (s.cycle.empty()) forget_last_cycle(s);
    s.step.image_of_cycle = static_cast<int>(s.cycle.size()) + 1;
    const motion::MotionPrediction prediction = predict(s, since_last_s);
    const bool is_credible = measure_newest(s, prediction, since_last_s);
    record_vectors(s, is_credible);
    accept_motion(s, is_credible, prediction, since_last_s);
    publish_motion(s, since_last_s);
    judge_blocks(s);
    observe_pitch(s);
    if (!s.step.end_of_cycle) return;
    publish_obstacles(s);
    begin_cycle(s);
    learn_pitch(s);
}

/// Takes in a field that can be used.
void follow(Impl& s, const Field& field) {
    const double since_last_s = s.has_reference ? field.timestamp_s - last_picture_s(s) : 0.0;
    const bool new_camera = !s.has_reference || !same_geometry(s.camera, field.camera);
    if (new_camera) s.pitch.restart();
    s.newest = {field, RayMapper(field.camera)};
    correct_pitch(s, s.newest);
    if (new_camera || since_last_s > s.params.rate.gap_max_s) {
        restart(s, new_camera);
    } else {
        compare(s, since_last_s);
    }
}

flow::Matcher own_matcher(const Params& params) {
    if (params.flow.matcher != flow::MatcherKind::Sad) {
        throw std::invalid_argument(
            "flow.matcher = lk: the pipeline itself has no such matcher; give it one, or use make_state() of "
            "flownav::sensor");
    }
    return flow::BlockMatcher(params.flow, params.threads);
}

}  // namespace

State::State(const Params& params) : State(params, own_matcher(params)) {}
State::State(const Params& params, flow::Matcher matcher) : impl_(std::make_unique<Impl>()) {
    impl_->params = params;
    impl_->matcher = std::move(matcher);
}
State::~State() = default;
State::State(State&&) noexcept = default;
State& State::operator=(State&&) noexcept = default;

State State::clone() const {
    State copy(impl_->params, impl_->matcher);
    *copy.impl_ = *impl_;
    return copy;
}

const Step& State::last_step() const {
    return impl_->step;
}

const Step& step(State& state, const Field& field) {
    Impl& s = state.impl();
    clear_outputs(s.step);
    const FieldFault fault = fault_of(field, s.newest_s);
    const double since_field_s = begin_step(s, field, fault);
    if (fault == FieldFault::None) {
        follow(s, field);
    } else {
        carry_over(s, s.has_reference ? s.newest_s.value_or(0.0) - last_picture_s(s) : 0.0, since_field_s);
    }
    s.carried_error.note(s.step, s.has_reference ? since_field_s : 0.0, s.params.rate.carry_max_s);
    s.step.carried = s.carried_error.pose();
    return s.step;
}

const char* kernel_name() {
    return flow::default_kernel().name;
}

}  // namespace flownav::pipeline
