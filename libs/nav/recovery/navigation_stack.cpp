#include "flownav/nav/navigation_stack.h"

#include <algorithm>
#include <utility>

namespace flownav::nav {
namespace {

/// The guard for a navigator and a map: its silent_s is at least 1.5 periods of the navigator.
GuardParams fitted(GuardParams guard, const NavigationParams& navigation, const mapping::MapParams& map) {
    guard.ground.limits = map.occupancy;
    guard.silent_s = std::max(guard.silent_s, 1.5 * navigation.controller_period_s);
    return guard;
}

}  // namespace

NavigationStack::NavigationStack(const NavigationParams& navigation, const mapping::MapParams& map,
                                 const GuardParams& guard, RecoveryManager recovery, const Pose2& start)
    : params_(navigation),
      pose_(navigation.robot, start),
      local_(map),
      map_(map),
      recovery_(std::move(recovery)),
      guard_(navigation.robot, fitted(guard, navigation, map)) {}

void NavigationStack::odometry(double time_s, const Pose2& T_odom_robot, const MotionCommand& motion) {
    motion_ = motion;
    pose_.odometry(time_s, T_odom_robot);
    guard_.odometry(time_s, T_odom_robot);
}

void NavigationStack::update(const SensorUpdate& update) {
    const double time_s = update.report.timestamp_s;
    if (!update.report.repeated) pose_.flow(time_s, update.T_start_robot);
    if (update.by_camera) guard_.sensed(update.report);
    const bool has_scan = update.contacts.gate != ContactGate::Off;
    if (!update.report.end_of_cycle && !has_scan) return;
    const Pose2 T_map_robot = pose_.at(time_s);
    const mapping::ObstacleSet set{time_s, T_map_robot, update.points, update.ground, update.contacts};
    // A robot that sees nothing new, such as one that stands, forgets nothing.
    if (mapping::is_empty(set)) {
        local_.redraw(T_map_robot);
    } else {
        local_.insert(set);
        map_.insert(set);
    }
    guard_.mapped(local_.grid(), time_s, T_map_robot);
    if (has_scan) guard_.scanned(update.contacts, time_s, T_map_robot);
}

MotionCommand NavigationStack::command(double time_s, const FaultInjection& fault_injection) {
    just_decided_ = !decided_s_ || time_s - *decided_s_ >= params_.controller_period_s - 1e-6;
    if (just_decided_) decide(time_s, fault_injection);
    safety_ = guard_.check(time_s, pose_.now(), motion_);
    return safety_.command;
}

void NavigationStack::decide(double time_s, const FaultInjection& fault_injection) {
    decided_s_ = time_s;
    local_.redraw(pose_.now());
    const bool blind = safety_.action == GuardAction::Stop && is_fault_of_sensing(safety_.reason);
    const Situation situation{time_s, pose_.now(), motion_, &local_.grid(), !blind};
    decision_ = recovery_.decide(situation, map_.grid());
    const auto proposal = fault_injection ? fault_injection(time_s, decision_.command) : decision_.command;
    if (proposal) guard_.proposed(time_s, *proposal);
}

}  // namespace flownav::nav
