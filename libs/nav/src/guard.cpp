#include "flownav/nav/guard.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flownav/nav/motion_model.h"
#include "sentence.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double outline_step_wanted_m = 0.05;
constexpr double inside_cells = 0.75;
constexpr double standing_mps = 0.01;
constexpr double slowest_mps = 0.02;  // of the outline: slower is a stop
constexpr int halvings = 5;           // of the search for the fastest speed
constexpr double hurry = 1.5;         // a robot may be this much faster than its model
constexpr double pose_jump_m = 0.25;
constexpr double pose_jump_rad = 0.2;
constexpr double rounding_m = 1e-7;

/// Points all along the outline, a little inside, where the cells below the robot are driven over.
std::vector<Vector2d> points_around(const Polygon& polygon, double inside_m) {
    std::vector<Vector2d> points;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d& a = polygon[i];
        const Vector2d side = polygon[(i + 1) % polygon.size()] - a;
        const Vector2d inward = Vector2d(-side.y(), side.x()).normalized() * inside_m;
        const int steps = std::max(1, static_cast<int>(std::ceil(side.norm() / outline_step_wanted_m)));
        for (int k = 0; k < steps; ++k) points.emplace_back(a + side * (k + 0.5) / steps + inward);
    }
    return points;
}

/// The path, and what a robot that came to stand a little later would pass.
std::vector<Pose2> prolonged(std::vector<Pose2> path, const MotionCommand& command, double time_s) {
    const Pose2 end = path.back();
    for (const double share : {0.5, 1.0}) path.push_back(compose(end, pose_after(command, share * time_s)));
    return path;
}

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
      radius_m_(circumscribed_radius_m(robot.footprint_m)),
      outline_m_(points_around(robot.footprint_m, inside_cells * params.ground.cell_m)),
      sensor_(params.sensor),
      odometry_(robot, params.odometry),
      ground_(params.ground),
      hold_s_(params.period_s) {}

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

void Guard::proposed(double time_s, const MotionCommand& command) {
    proposal_ = TimedCommand{time_s, command};
}

Verdict Guard::judge(double time_s, const Pose2& T_map_robot, const MotionCommand& motion) {
    note_pose(time_s, T_map_robot, motion);
    const Fault fault = held(fault_now(time_s), time_s);
    const Now now = look(time_s, T_map_robot, motion);
    Verdict verdict;
    if (fault && !may_turn_out(fault, time_s)) {
        verdict = {{}, GuardAction::Stop, fault.reason, fault.why};
    } else {
        verdict = allow(now, fault ? MotionCommand{0.0, limited().omega_radps} : limited());
        if (fault && verdict.action == GuardAction::Pass)
            verdict = {verdict.command, GuardAction::Slow, fault.reason, fault.why};
    }
    return sent(now, verdict);
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
    const Fault sensor = sensor_.fault(time_s);
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
    hold_s_ = std::max(params_.period_s, std::min(dt_s, 1.0));
    if (last_) {
        const Pose2 moved = compose(inverse(last_->T_map_robot), T_map_robot);
        const double way_max_m = hurry * std::max(robot_.v_max_mps, robot_.v_back_mps) * dt_s + pose_jump_m;
        const double turn_max_rad = hurry * robot_.omega_max_radps * dt_s + pose_jump_rad;
        if (std::hypot(moved.x_m, moved.y_m) > way_max_m || std::abs(moved.yaw_rad) > turn_max_rad) {
            ground_.forget();
            jumped_s_ = time_s;
        }
    }
    ground_.drive_over(robot_.footprint_m, time_s, T_map_robot);
    if (over_unseen_) crept_m_ += std::abs(motion.v_mps) * dt_s;
    const bool stands = std::abs(motion.v_mps) < standing_mps;
    if (stands && !standing_since_s_) standing_since_s_ = time_s;
    if (!stands) standing_since_s_.reset();
    last_ = Moment{time_s, T_map_robot};
}

Guard::Now Guard::look(double time_s, const Pose2& T_map_robot, const MotionCommand& motion) const {
    Now now{time_s, T_map_robot, motion, {}};
    now.motion.v_mps =
        std::clamp(motion.v_mps, -hurry * robot_.v_back_mps, hurry * std::max(robot_.v_max_mps, 0.0));
    now.motion.omega_radps =
        std::clamp(motion.omega_radps, -hurry * robot_.omega_max_radps, hurry * robot_.omega_max_radps);
    const double fastest_mps = std::max({std::abs(now.motion.v_mps), robot_.v_max_mps, robot_.v_back_mps});
    const double reach_m = stopping_distance_m(robot_, fastest_mps) + fastest_mps * params_.period_s +
                           2.0 * radius_m_ + params_.touch_m + params_.margin_s * outline_mps(now.motion);
    const Pose2 T_robot_map = inverse(T_map_robot);
    for (const Vector2d& p : ground_.obstacles({T_map_robot.x_m, T_map_robot.y_m}, reach_m, time_s))
        now.obstacles_m.push_back(transform(T_robot_map, p));
    now.nearest_m = std::numeric_limits<double>::infinity();
    const auto inside = [&](const Vector2d& p) {
        const double distance_m = signed_distance_m(robot_.footprint_m, p);
        if (distance_m > 0.0) now.nearest_m = std::min(now.nearest_m, distance_m);
        return distance_m <= 0.0;  // what stands where the robot stands is none
    };
    now.obstacles_m.erase(std::remove_if(now.obstacles_m.begin(), now.obstacles_m.end(), inside),
                          now.obstacles_m.end());
    return now;
}

double Guard::outline_mps(const MotionCommand& command) const {
    return std::abs(command.v_mps) + std::abs(command.omega_radps) * radius_m_;
}

MotionCommand Guard::limited() const {
    const MotionCommand& wanted = proposal_->command;
    return {std::clamp(wanted.v_mps, -robot_.v_back_mps, robot_.v_max_mps),
            std::clamp(wanted.omega_radps, -robot_.omega_max_radps, robot_.omega_max_radps)};
}

bool Guard::touches(const Now& now, const Pose2& T_robot_then, double margin_m, Vector2d& where_m) const {
    const Pose2 T_then_robot = inverse(T_robot_then);
    for (const Vector2d& obstacle : now.obstacles_m) {
        const Vector2d p = transform(T_then_robot, obstacle);
        if (p.norm() > radius_m_ + margin_m) continue;
        if (signed_distance_m(robot_.footprint_m, p) >= margin_m) continue;
        where_m = obstacle;
        return true;
    }
    return false;
}

bool Guard::is_unseen(const Now& now, const Pose2& T_robot_then) const {
    const Pose2 T_map_then = compose(now.T_map_robot, T_robot_then);
    const int most = static_cast<int>(params_.unseen_max_m / outline_step_wanted_m);
    int unseen = 0;
    for (const Vector2d& point : outline_m_) {
        unseen += !ground_.is_seen(transform(T_map_then, point), now.time_s);
        if (unseen > most) return true;
    }
    return false;
}

Guard::Outlook Guard::outlook(const Now& now, const MotionCommand& candidate) const {
    const std::vector<Pose2> path =
        stopping_path(robot_, now.motion, sent_, now.time_s, {now.time_s, candidate}, hold_s_);
    const double half_cell_m = params_.ground.cell_m / 2;
    const double touch_m = std::min(params_.touch_m + half_cell_m, now.nearest_m - rounding_m);
    // A crawling robot may stay as near as it is, but come no nearer.
    const double fast_mps = std::max(0.0, outline_mps(candidate) - params_.crawl_mps);
    const double margin_m =
        fast_mps > 0.0 ? params_.touch_m + half_cell_m + params_.margin_s * fast_mps : touch_m;
    Outlook outlook;
    for (std::size_t i = 1; i < path.size() && !outlook.touches; ++i)
        outlook.touches = touches(now, path[i], margin_m, outlook.where_m);
    if (outlook.touches) return outlook;
    const double spare_s = 2.0 * inside_cells * params_.ground.cell_m / outline_mps(candidate);
    const std::vector<Pose2> on = prolonged(path, candidate, spare_s);
    outlook.unseen = std::any_of(on.begin() + 1, on.end(),
                                 [&](const Pose2& T_robot_then) { return is_unseen(now, T_robot_then); });
    return outlook;
}

Fault Guard::objection(const Now& now, const MotionCommand& candidate) const {
    const double fast_mps = outline_mps(candidate);
    if (fast_mps == 0.0) return {};
    const bool crawls = fast_mps <= params_.crawl_mps + rounding_m;
    if (probing_since_s_ && !crawls) {
        return {GuardReason::OdometryContradiction, "flow and wheels must agree about a slow motion first"};
    }
    const Outlook ahead = outlook(now, candidate);
    if (ahead.touches) {
        return {GuardReason::ObstacleAhead, sentence("an obstacle at (", ahead.where_m.x(), ", ",
                                                     ahead.where_m.y(), ") m, seen from the robot")};
    }
    if (!ahead.unseen) return {};
    if (!crawls) return {GuardReason::UnseenAhead, "ground on the way has not been seen"};
    if (probing_since_s_ || crept_m_ >= params_.crawl_max_m) {
        return {GuardReason::UnseenAhead,
                sentence("crept ", crept_m_, " m over unseen ground and saw no new ground")};
    }
    return {};
}

Verdict Guard::allow(const Now& now, const MotionCommand& wanted) const {
    const Fault first = objection(now, wanted);
    if (!first) return {wanted, GuardAction::Pass, GuardReason::None, ""};
    const double fast_mps = outline_mps(wanted);
    double good = 0.0, bad = 1.0;
    const auto try_share = [&](double share) {
        (objection(now, scaled(wanted, share)) ? bad : good) = share;
    };
    if (fast_mps > params_.crawl_mps) try_share(params_.crawl_mps / fast_mps);
    for (int i = 0; i < halvings; ++i) try_share((good + bad) / 2);
    const MotionCommand slow = scaled(wanted, good);
    if (outline_mps(slow) < slowest_mps) return {{}, GuardAction::Stop, first.reason, first.why};
    return {slow, GuardAction::Slow, first.reason, first.why};
}

Verdict Guard::sent(const Now& now, const Verdict& verdict) {
    // Counts as creeping what may lead over unseen ground.
    over_unseen_ = outline_mps(verdict.command) > 0.0 && outlook(now, verdict.command).unseen;
    sent_.push_back({now.time_s, verdict.command});
    // The last one before the delay is still in force.
    while (sent_.size() > 1 && sent_[1].time_s <= now.time_s - robot_.delay_s - params_.period_s)
        sent_.pop_front();
    log(now.time_s, verdict);
    return verdict;
}

void Guard::log(double time_s, const Verdict& verdict) {
    const auto rank = [](const GuardEvent& e) { return std::pair(e.action, e.reason); };
    const GuardEvent event{time_s, verdict.action, verdict.reason, verdict.why};
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
