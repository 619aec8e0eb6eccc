#include "flownav/nav/guard.h"

#include <algorithm>
#include <cmath>

#include "sentence.h"

namespace flownav::nav {
namespace {

constexpr double standing_mps = 0.01;
constexpr double slowest_mps = 0.02;  // of the outline: slower is a stop
constexpr int halvings = 5;           // of the search for the fastest speed
constexpr double rounding_m = 1e-7;
constexpr double scan_turn_max_rad = 0.3;  // since the last contact scan, to drive faster than a crawl

MotionCommand scaled(const MotionCommand& command, double share) {
    return {command.v_mps * share, command.omega_radps * share};
}

bool needs_probe(GuardReason reason) {
    return reason == GuardReason::SensorFrozen || reason == GuardReason::OdometryContradiction;
}

}  // namespace

Guard::Guard(const RobotModel& robot, const GuardParams& params)
    : robot_(robot),
      params_(params),
      sensor_(params.sensor),
      odometry_(robot, params.odometry),
      pose_jumps_(robot, params.pose_jump_m, params.pose_jump_rad),
      ground_(params.ground),
      collision_checker_(robot, params.collision_checker, params.ground.cell_m),
      hold_s_(params.collision_checker.period_s) {}

void Guard::sensed(const SensorReport& report) {
    sensor_.sensed(report);
    odometry_.sensed(report);
}

void Guard::odometry(double time_s, const Pose2& T_odom_robot) {
    odometry_.odometry(time_s, T_odom_robot);
}

void Guard::mapped(const mrpt::maps::COccupancyGridMap2D& local_map, double time_s,
                   const Pose2& T_map_robot) {
    map_s_ = time_s;
    if (ground_.note(local_map, time_s, T_map_robot) >= params_.new_cells) crept_m_ = 0.0;
}

void Guard::scanned(const ContactScan& scan, double time_s, const Pose2& T_map_robot) {
    if (scan.gate == ContactGate::Off) return;
    has_scans_ = true;
    if (scan.gate != ContactGate::Open) return;
    ground_.note(scan, time_s, T_map_robot);
    scan_yaw_rad_ = T_map_robot.yaw_rad + scan.T_robot_scan.yaw_rad;
}

void Guard::proposed(double time_s, const MotionCommand& command) {
    proposal_ = TimedCommand{time_s, command};
}

SafetyDecision Guard::check(double time_s, const Pose2& T_map_robot, const MotionCommand& motion) {
    note_pose(time_s, T_map_robot, motion);
    const Fault fault = held(fault_now(time_s), time_s);
    const Surroundings now = collision_checker_.look(ground_, time_s, T_map_robot, motion);
    SafetyDecision safety;
    if (fault && !may_turn_out(fault, time_s)) {
        safety = {{}, GuardAction::Stop, fault.reason, fault.why};
    } else {
        safety = allow(now, fault ? MotionCommand{0.0, limited().omega_radps} : limited());
        if (fault && safety.action == GuardAction::Pass)
            safety = {safety.command, GuardAction::Slow, fault.reason, fault.why};
    }
    return sent(now, safety);
}

Fault Guard::fault_now(double time_s) {
    if (!proposal_) return {GuardReason::NavigatorSilent, "no proposal of the navigator yet"};
    const double silent_s = time_s - proposal_->time_s;
    if (silent_s > params_.silent_s) {
        return {GuardReason::NavigatorSilent, sentence("no proposal of the navigator for ", silent_s, " s")};
    }
    if (!std::isfinite(proposal_->command.v_mps) || !std::isfinite(proposal_->command.omega_radps)) {
        return {GuardReason::NavigatorSilent, "the navigator proposes a speed that is not a number"};
    }
    // Asked whether it counts or not: it has to know when fields arrived.
    Fault sensor = sensor_.fault(time_s);
    if (sensor && params_.needs_fields) return sensor;
    if (map_s_ && time_s - *map_s_ > params_.map_stale_s) {
        return {GuardReason::SensorStale, sentence("no new map for ", time_s - *map_s_, " s")};
    }
    if (!map_s_ && !params_.needs_fields) return {GuardReason::SensorStale, "no map has come yet"};
    if (time_s - jumped_s_ < params_.odometry.hold_s) {
        return {GuardReason::OdometryContradiction, "the pose in the map jumped: what was seen is void"};
    }
    return odometry_.fault(time_s);
}

Fault Guard::held(const Fault& fault, double time_s) {
    if (fault) {
        if (needs_probe(fault.reason) && !probe_wanted_) {
            probe_wanted_ = true;
            probe_pause_s_ = std::clamp(2.0 * probe_pause_s_, params_.probe_wait_s, params_.probe_max_s);
        }
        holding_ = fault;
        fault_s_ = time_s;
        return fault;
    }
    if (!holding_) {
        if (probing_since_s_ && odometry_.is_confirmed_since(*probing_since_s_)) {
            probing_since_s_.reset();
            probe_pause_s_ = 0.0;
        }
        return {};
    }
    double wait_s = holding_.reason == GuardReason::NavigatorSilent ? 0.0 : params_.resume_s;
    if (probe_wanted_) wait_s = std::max(wait_s, probe_pause_s_);
    if (time_s - fault_s_ < wait_s) return holding_;
    if (probe_wanted_) probing_since_s_ = time_s;
    probe_wanted_ = false;
    holding_ = {};
    return {};
}

bool Guard::may_turn_out(const Fault& fault, double time_s) const {
    return fault.reason == GuardReason::SensorBlind && sensor_.is_partly_blind() && standing_since_s_ &&
           time_s - *standing_since_s_ >= params_.turn_free_s;
}

void Guard::note_pose(double time_s, const Pose2& T_map_robot, const MotionCommand& motion) {
    const double dt_s = last_ ? time_s - last_->time_s : 0.0;
    hold_s_ = std::max(params_.collision_checker.period_s, std::min(dt_s, 1.0));
    if (last_ && pose_jumps_.is_jump(last_->T_map_robot, T_map_robot, dt_s)) {
        ground_.forget();
        jumped_s_ = time_s;
    }
    ground_.mark_traversed(robot_.footprint_m, time_s, T_map_robot);
    if (over_unseen_) crept_m_ += std::abs(motion.v_mps) * dt_s;
    const bool stands = std::abs(motion.v_mps) < standing_mps;
    if (stands && !standing_since_s_) standing_since_s_ = time_s;
    if (!stands) standing_since_s_.reset();
    last_ = Moment{time_s, T_map_robot};
}

MotionCommand Guard::limited() const {
    const MotionCommand& wanted = proposal_->command;
    return {std::clamp(wanted.v_mps, -robot_.v_back_mps, robot_.v_max_mps),
            std::clamp(wanted.omega_radps, -robot_.omega_max_radps, robot_.omega_max_radps)};
}

Fault Guard::objection(const Surroundings& now, const MotionCommand& candidate) const {
    const double fast_mps = collision_checker_.outline_mps(candidate);
    if (fast_mps == 0.0) return {};
    const bool crawls = fast_mps <= params_.collision_checker.crawl_mps + rounding_m;
    if (probing_since_s_ && !crawls) {
        return {GuardReason::OdometryContradiction, "flow and wheels must agree about a slow motion first"};
    }
    const Forecast ahead = collision_checker_.forecast(ground_, now, sent_, candidate, hold_s_);
    if (ahead.touches) {
        return {GuardReason::ObstacleAhead, sentence("an obstacle at (", ahead.where_m.x(), ", ",
                                                     ahead.where_m.y(), ") m, seen from the robot")};
    }
    if (ahead.unconfirmed) {
        return {GuardReason::UnconfirmedAhead,
                "ground on the way was in view and was not confirmed as floor"};
    }
    if (!crawls && has_turned_since_scan(now, candidate)) {
        return {GuardReason::UnconfirmedAhead,
                "has turned since the last contact scan: what stands ahead now shows when it moves"};
    }
    return ahead.unseen ? objection_to_unseen(ahead, fast_mps) : objection_to_speed(ahead, candidate);
}

/// True when the robot is to drive where no contact scan has looked: scans need travel, and it has turned.
bool Guard::has_turned_since_scan(const Surroundings& now, const MotionCommand& candidate) const {
    return scan_yaw_rad_ && candidate.v_mps > 0.0 &&
           std::abs(wrap_angle(now.T_map_robot.yaw_rad - *scan_yaw_rad_)) > scan_turn_max_rad;
}

/// Why the robot may not drive over ground that it has neither seen nor scanned; empty when it may crawl on.
Fault Guard::objection_to_unseen(const Forecast& ahead, double fast_mps) const {
    const CollisionCheckerParams& speeds = params_.collision_checker;
    const bool is_slow = fast_mps <= speeds.unconfirmed_mps + rounding_m;
    if (!ahead.unscanned && is_slow && !probing_since_s_) return {};
    const bool crawls = fast_mps <= speeds.crawl_mps + rounding_m;
    if (!crawls) return {GuardReason::UnseenAhead, "ground on the way has not been seen"};
    if (probing_since_s_ || crept_m_ >= params_.crawl_max_m) {
        return {GuardReason::UnseenAhead,
                sentence("crept ", crept_m_, " m over unseen ground and saw no new ground")};
    }
    return {};
}

/// Why the robot may not drive so fast over ground that it has seen: straight ahead obstacles are found late.
Fault Guard::objection_to_speed(const Forecast& ahead, const MotionCommand& candidate) const {
    const double slow_mps = params_.collision_checker.unconfirmed_mps;
    if (!has_scans_ || !ahead.unproven || candidate.v_mps <= slow_mps + rounding_m) return {};
    return {GuardReason::UnconfirmedAhead,
            sentence("the floor on the way is not confirmed: at most ", slow_mps, " m/s")};
}

SafetyDecision Guard::allow(const Surroundings& now, const MotionCommand& wanted) const {
    const Fault first = objection(now, wanted);
    if (!first) return {wanted, GuardAction::Pass, GuardReason::None, ""};
    const double fast_mps = collision_checker_.outline_mps(wanted);
    double good = 0.0, bad = 1.0;
    const auto try_share = [&](double share) {
        (objection(now, scaled(wanted, share)) ? bad : good) = share;
    };
    if (fast_mps > params_.collision_checker.crawl_mps)
        try_share(params_.collision_checker.crawl_mps / fast_mps);
    for (int i = 0; i < halvings; ++i) try_share((good + bad) / 2);
    const MotionCommand slow = scaled(wanted, good);
    if (collision_checker_.outline_mps(slow) < slowest_mps)
        return {{}, GuardAction::Stop, first.reason, first.why};
    return {slow, GuardAction::Slow, first.reason, first.why};
}

SafetyDecision Guard::sent(const Surroundings& now, const SafetyDecision& safety) {
    // Counts as creeping what may lead over ground that was neither seen nor scanned.
    over_unseen_ = collision_checker_.outline_mps(safety.command) > 0.0 &&
                   collision_checker_.forecast(ground_, now, sent_, safety.command, hold_s_).unscanned;
    sent_.push_back({now.time_s, safety.command});
    // The last one before the delay is still in force.
    while (sent_.size() > 1 &&
           sent_[1].time_s <= now.time_s - robot_.delay_s - params_.collision_checker.period_s)
        sent_.pop_front();
    log(now.time_s, safety);
    return safety;
}

void Guard::log(double time_s, const SafetyDecision& safety) {
    const auto rank = [](const GuardEvent& e) { return std::pair(gravity(e.action), gravity(e.reason)); };
    const GuardEvent event{time_s, safety.action, safety.reason, safety.why};
    const bool same = !events_.empty() && rank(events_.back()) == rank(event);
    const bool milder = !events_.empty() && rank(event) < rank(events_.back());
    if (!milder) milder_since_s_.reset();
    if (same) return;
    if (milder && !milder_since_s_) milder_since_s_ = time_s;
    if (milder && time_s - *milder_since_s_ < params_.log_quiet_s) return;
    milder_since_s_.reset();
    events_.push_back(event);
    if (events_.size() > params_.events_max) events_.pop_front();
}

}  // namespace flownav::nav
