// The pose over gaps between the fields, how far it can be relied on, and the motion between two times.
#include <algorithm>

#include "record.h"
#include "state.h"

namespace flownav::pipeline {

/// Keeps how far the pose can be relied on, and the pose itself for motion_between().
void State::Impl::note_pose(double since_field_s) {
    const KnownParts known{step_.motion.omega_measured || bridged_,
                           step_.motion.forward_measured || bridged_};
    carried_error_.note(step_, known, since_field_s, params_.rate.carry_max_s);
    const CarriedPose carried = carried_error_.pose();
    record_reliability(step_, carried, uncertainty_.covariance(T_start_robot_, carried), others_.checks());
    if (carried.since_s > 0.0) carried_s_ += since_field_s;
    if (since_field_s <= 0.0 && step_.fault != FieldFault::None) return;
    history_.note({step_.timestamp_s, T_start_robot_,
                   uncertainty_.way_variance_m2() + carried.sigma_m * carried.sigma_m,
                   uncertainty_.turn_variance_rad2() + carried.sigma_rad * carried.sigma_rad, carried_s_});
}

/// By the odometry of the fields where all of it was measured, else by the wheels where they are believed.
std::optional<MotionBetween> State::Impl::motion_between(double from_s, double to_s) const {
    const auto by_fields = history_.between(from_s, to_s);
    if (by_fields && by_fields->source != MotionSource::Prediction) return by_fields;
    const bool backward = to_s < from_s;
    const ToldMotion told = others_.between(std::min(from_s, to_s), std::max(from_s, to_s));
    const auto pose = told_pose(told);
    if (!pose) return by_fields;
    return MotionBetween{backward ? inverse(*pose) : *pose, told.way->sigma, told.turn->sigma,
                         MotionSource::Wheels};
}

/// Adds the motion since the field before, over a gap, to the pose, as other sensors tell it.
void State::Impl::bridge_gap(double gap_s) {
    const double now_s = newest_.field.timestamp_s;
    const ToldMotion told = others_.between(now_s - gap_s, now_s);
    const auto moved = told_pose(told);
    if (!moved) return;
    uncertainty_.begin_cycle();
    uncertainty_.move(T_start_robot_, completed(EgoMotion{}, told));
    T_start_robot_ = compose(T_start_robot_, *moved);
    record_pose(step_, T_start_robot_);
    bridged_ = true;
}

}  // namespace flownav::pipeline
