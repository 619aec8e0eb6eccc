#include "flownav/pipeline/pipeline.h"

#include <algorithm>
#include <cmath>

#include "field_quality.h"
#include "flownav/flow/matcher_registry.h"
#include "flownav/obstacles/drops.h"
#include "flownav/obstacles/virtual_scan.h"
#include "measure_motion.h"
#include "record.h"
#include "short_blocks.h"
#include "state.h"

namespace flownav::pipeline {
namespace {

constexpr std::size_t coarse_step = 3;  // the search looks at every third block

/// Ratio of the residuals of a field to the deviations of its vectors; 1 where the flow shows no motion that
/// has residuals.
double noise_factor_of(const AcceptedMotion& accepted, const motion::MotionEstimate& estimate) {
    const bool by_others = accepted.status != FieldStatus::Ok && accepted.is_usable();
    return by_others ? 1.0 : estimate.noise_factor;
}

}  // namespace

State::State(const Params& params)
    : State(params, flow::make_matcher(params.flow.matcher, params.flow, params.threads)) {}
State::State(const Params& params, flow::Matcher matcher)
    : impl_(std::make_unique<Impl>(params, std::move(matcher))) {}
State::~State() = default;
State::State(State&&) noexcept = default;
State& State::operator=(State&&) noexcept = default;

State State::clone() const {
    State copy(Params{}, flow::Matcher());
    *copy.impl_ = *impl_;
    return copy;
}

const Step& State::last_step() const {
    return impl_->last_step();
}

std::optional<MotionBetween> State::motion_between(double from_s, double to_s) const {
    return impl_->motion_between(from_s, to_s);
}

void note_wheels(State& state, const WheelPose& reading) {
    state.impl_->note(reading);
}

void note_gyro(State& state, const GyroRate& reading) {
    state.impl_->note(reading);
}

const Step& step(State& state, const Field& field) {
    return state.impl_->take(field);
}

const char* kernel_name() {
    return flow::default_kernel().name;
}

const Step& State::Impl::take(const Field& field) {
    const FieldFault fault = fault_of(field, newest_s_);
    record_field(step_, field, fault, newest_s_);
    const bool in_time = fault != FieldFault::TimeNotRising;
    const double since_field_s = in_time && newest_s_ ? field.timestamp_s - *newest_s_ : 0.0;
    if (in_time) newest_s_ = field.timestamp_s;
    if (in_time) others_.note_field(field.timestamp_s);
    bridged_ = false;
    if (fault == FieldFault::None) {
        follow(field, since_field_s);
    } else {
        carry_over_field(since_field_s);
    }
    note_pose(has_reference_ ? since_field_s : 0.0);
    return step_;
}

/// Compares the field with the reference, or begins a new chain with it.
void State::Impl::follow(const Field& field, double since_field_s) {
    const double since_last_s = has_reference_ ? field.timestamp_s - last_picture_s() : 0.0;
    const bool new_camera = !has_reference_ || !same_geometry(camera_, field.camera);
    if (new_camera) pitch_.restart();
    newest_ = {field, RayMapper(field.camera)};
    correct_pitch(newest_);
    record_pitch(step_, pitch_.correction_rad());
    if (new_camera || since_last_s > params_.rate.gap_max_s) {
        restart(new_camera, since_field_s);
    } else {
        compare(since_last_s);
    }
}

/// Begins a new chain: no field before the newest can be compared with it.
void State::Impl::restart(bool new_camera, double since_field_s) {
    if (new_camera) new_layout();
    record_start(step_, has_reference_);
    if (has_reference_) bridge_gap(since_field_s);
    obstacles::forget_images(contact_memory_);
    contacts_.gate = ContactGate::Off;
    contacts_.strips.clear();
    record_contacts(step_, contacts_, false);
    rates_ = {};
    begin_cycle();
}

/// The stages: flow, ego-motion, odometry, classes of the blocks, surroundings.
void State::Impl::compare(double since_last_s) {
    const int image = static_cast<int>(cycle_.size()) + 1;
    const Elapsed elapsed{since_last_s, newest_.field.timestamp_s - reference_.field.timestamp_s};
    const ToldMotion told = others_.between(reference_.field.timestamp_s, newest_.field.timestamp_s);
    const motion::MotionPrediction prediction = predict(rates_, cycle_, elapsed, told);
    const bool is_credible =
        measure_motion({reference_, newest_, layout_, coarse_layout_, rates_, cycle_, since_last_s, told},
                       prediction, {params_, matcher_}, measured_, trial_);
    const AcceptedMotion accepted =
        estimate(measured_, is_credible, prediction, told, rates_.sigma_v_relative, since_last_s);
    record_vectors(step_, {measured_, layout_, reference_.field.camera.mount, params_.flow,
                           is_credible || accepted.is_usable(), image});
    const IntegratedMotion integrated =
        integrate(accepted, odometry_, rates_, newest_.field.timestamp_s, elapsed, params_.rate.carry_max_s);
    const CyclePlan plan =
        plan_after(accepted, integrated.rates, image, quality_, since_last_s, params_.rate);
    record_motion(step_, accepted, integrated, plan);
    cycle_.push_back(image_of_cycle(reference_.field.camera, accepted.motion,
                                    noise_factor_of(accepted, measured_.estimate), params_.motion.geometry));

    classify(step_.blocks, cycle_, layout_, params_.obstacles, classes_);
    record_labels(step_, classes_);
    advance(accepted, integrated, plan);
    if (!plan.ends) {
        continue_scan();
        return;
    }
    if (accepted.status == FieldStatus::Ok)
        others_.compare(reference_.field.timestamp_s, newest_.field.timestamp_s, measured_.estimate.motion);
    scan_contacts(accepted.motion);
    reconstruct({step_.blocks, classes_, cycle_, reference_, newest_, contacts_}, params_.obstacles,
                surroundings_);
    record_surroundings(step_, surroundings_);
    end_cycle(accepted.motion);
}

/// Does a part of the contact scan under way, so that no field pays for all of it, and publishes a whole one.
void State::Impl::continue_scan() {
    if (!obstacles::continue_scan(contact_memory_, params_.obstacles.contacts, contacts_)) return;
    T_start_scan_ = T_start_next_scan_;
    obstacles::mark_drops(short_blocks_.floor_points_m, short_blocks_.sorted_m, contacts_);
    contacts_.T_robot_scan = compose(inverse(T_start_robot_), T_start_scan_);
    record_contacts(step_, contacts_, true);
}

/// Begins to scan the newest field, which ends a cycle of this motion, for contacts.
void State::Impl::scan_contacts(const EgoMotion& motion) {
    if (!params_.obstacles.contacts.on) return;
    while (obstacles::is_scanning(contact_memory_)) continue_scan();
    pitch_sum_rad_ += motion.pitch_rad;
    const double way_error = motion.sigma_forward_m / std::max(std::abs(motion.forward_m), 1e-6);
    const obstacles::CycleEnd end{newest_.field.image, newest_.mapper,
                                  T_start_robot_,      pitch_sum_rad_,
                                  way_error,           motion.forward_measured && motion.omega_measured};
    if (obstacles::begin_scan(contact_memory_, end, params_.obstacles.contacts)) {
        T_start_next_scan_ = T_start_robot_;
        find_short_blocks({step_.blocks, classes_, cycle_, reference_, newest_, contacts_}, short_blocks_);
        continue_scan();
    }
    contacts_.T_robot_scan = compose(inverse(T_start_robot_), T_start_scan_);
    record_contacts(step_, contacts_, step_.new_contacts);
}

/// Keeps the results of a field for the next one.
void State::Impl::advance(const AcceptedMotion& accepted, const IntegratedMotion& integrated,
                          const CyclePlan& plan) {
    rates_ = integrated.rates;
    odometry_.counted = integrated.counted;
    T_start_robot_ = integrated.T_start_robot;
    quality_ = plan.quality;
    uncertainty_.move(odometry_.T_start_reference, accepted.motion);
    if (!accepted.is_usable()) return;
    odometry_.measured = accepted.motion;
    odometry_.measured_s = newest_.field.timestamp_s;
    if (accepted.status != FieldStatus::Ok) return;
    // Vectors of the second half of a cycle: those of one block end anywhere in a pixel.
    const bool second_half = 2 * static_cast<int>(cycle_.size()) >= plan.images;
    if (params_.pitch_online && second_half && measured_.estimate.motion.forward_measured)
        pitch_.observe(measured_.samples, reference_.field.camera, accepted.motion, params_.motion.geometry);
}

/// The newest field becomes the reference, with the pitch that this cycle taught.
void State::Impl::end_cycle(const EgoMotion& motion) {
    pipeline::end_cycle(classes_);
    begin_cycle();
    if (!params_.pitch_online) return;
    pitch_.learn(motion);
    correct_pitch(reference_);
    aim_layouts();
}

void State::Impl::begin_cycle() {
    std::swap(reference_, newest_);
    cycle_.clear();
    has_reference_ = true;
    quality_.failures = 0;
    uncertainty_.begin_cycle();
    odometry_ = {T_start_robot_, EgoMotion{}, EgoMotion{}, reference_.field.timestamp_s};
    aim_layouts();
}

/// Carries the odometry on over a field without a usable image; the reference stays.
void State::Impl::carry_over_field(double since_field_s) {
    const double since_picture_s = has_reference_ ? newest_s_.value_or(0.0) - last_picture_s() : 0.0;
    CarriedMotion motion = carry_over(rates_, since_picture_s, since_field_s, params_.rate.carry_max_s);
    if (has_reference_ && newest_s_) {
        motion = told_instead(motion, others_.between(*newest_s_ - since_field_s, *newest_s_),
                              others_.between(reference_.field.timestamp_s, *newest_s_), since_field_s);
    }
    T_start_robot_ = compose(T_start_robot_, motion.T_before_now);
    record_carried_motion(step_, motion, T_start_robot_);
}

/// Places the blocks for the camera of the newest field.
void State::Impl::new_layout() {
    camera_ = newest_.field.camera;
    layout_ = flow::place_blocks(newest_.mapper, params_.flow);
    coarse_layout_ = flow::every_nth(layout_, coarse_step);
    reset(classes_, layout_.size());
    if (params_.obstacles.contacts.on) {
        obstacles::restart(contact_memory_, newest_.mapper);
        contacts_.strips.reserve(obstacles::strips_max);
        step_.contacts.strips.reserve(obstacles::strips_max);
        short_blocks_.floor_points_m.reserve(layout_.size());
        short_blocks_.sorted_m.reserve(layout_.size());
    }
    surroundings_.scan = obstacles::scan_layout(newest_.mapper, params_.obstacles);
    record_layout(step_, layout_.size(), surroundings_.scan);
}

void State::Impl::aim_layouts() {
    flow::set_reference(layout_, reference_.mapper);
    flow::set_reference(coarse_layout_, reference_.mapper);
}

/// Adds the learnt correction to the pitch of an image's camera.
void State::Impl::correct_pitch(ReferenceImage& image) const {
    if (pitch_.correction_rad() == 0.0) return;
    image.field.camera.mount.pitch_rad = camera_.mount.pitch_rad + pitch_.correction_rad();
    image.mapper = RayMapper(image.field.camera);
}

/// Time stamp of the last field that could be compared.
double State::Impl::last_picture_s() const {
    return (cycle_.empty() ? reference_ : newest_).field.timestamp_s;
}

}  // namespace flownav::pipeline
