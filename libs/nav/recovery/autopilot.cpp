#include "flownav/nav/autopilot.h"

#include <algorithm>
#include <utility>

namespace flownav::nav {
namespace {

/// A navigator that decides more seldom is not silent yet.
GuardParams patient_with(const NavigationParams& navigation, GuardParams guard) {
    guard.silent_s = std::max(guard.silent_s, 1.5 * navigation.decide_every_s);
    return guard;
}

}  // namespace

Autopilot::Autopilot(const NavigationParams& navigation, const MapParams& map, const GuardParams& guard,
                     Pilot pilot, const Pose2& start)
    : params_(navigation),
      pose_(navigation.robot, start),
      local_(map),
      map_(map),
      pilot_(std::move(pilot)),
      guard_(navigation.robot, patient_with(navigation, guard)) {}

void Autopilot::odometry(double time_s, const Pose2& T_odom_robot, const MotionCommand& motion) {
    motion_ = motion;
    pose_.odometry(time_s, T_odom_robot);
    guard_.odometry(time_s, T_odom_robot);
}

void Autopilot::sensed(const Sensed& sensed) {
    const double time_s = sensed.report.timestamp_s;
    if (!sensed.report.repeated) pose_.flow(time_s, sensed.T_start_robot);
    if (sensed.by_camera) guard_.sensed(sensed.report);
    if (!sensed.report.end_of_cycle) return;
    const Pose2 T_map_robot = pose_.at(time_s);
    // A robot that sees nothing new, such as one that stands, forgets nothing.
    if (sensed.points.empty() && sensed.ground.empty()) {
        local_.redraw(T_map_robot);
    } else {
        const ObstacleSet set{time_s, T_map_robot, sensed.points, sensed.ground};
        local_.insert(set);
        map_.insert(set);
    }
    guard_.mapped(local_.grid(), time_s, T_map_robot);
}

MotionCommand Autopilot::command(double time_s, const Tamper& tamper) {
    just_decided_ = !decided_s_ || time_s - *decided_s_ >= params_.decide_every_s - 1e-6;
    if (just_decided_) decide(time_s, tamper);
    verdict_ = guard_.judge(time_s, pose_.now(), motion_);
    return verdict_.command;
}

void Autopilot::decide(double time_s, const Tamper& tamper) {
    decided_s_ = time_s;
    local_.redraw(pose_.now());
    const bool blind = verdict_.action == GuardAction::Stop && is_fault_of_sensing(verdict_.reason);
    const Situation situation{time_s, pose_.now(), motion_, &local_.grid(), !blind};
    decision_ = pilot_.decide(situation, map_.grid());
    const auto proposal = tamper ? tamper(time_s, decision_.command) : decision_.command;
    if (proposal) guard_.proposed(time_s, *proposal);
}

}  // namespace flownav::nav
