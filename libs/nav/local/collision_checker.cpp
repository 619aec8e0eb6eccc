#include "flownav/nav/collision_checker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flownav/nav/jump_detector.h"
#include "flownav/nav/motion_model.h"
#include "local/contact_rule.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double outline_step_m = 0.05;
constexpr double unconfirmed_margin_m = 0.1;  // a scan confirms floor a little too far
constexpr double unproven_max_m = 0.05;       // of the outline
constexpr double inside_cells = 0.75;
constexpr double rounding_m = 1e-7;

/// Points all along the outline, a little inside, where the cells below the robot are driven over.
std::vector<Vector2d> points_around(const Polygon& polygon, double inside_m) {
    std::vector<Vector2d> points;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d& a = polygon[i];
        const Vector2d side = polygon[(i + 1) % polygon.size()] - a;
        const Vector2d inward = Vector2d(-side.y(), side.x()).normalized() * inside_m;
        const int steps = std::max(1, static_cast<int>(std::ceil(side.norm() / outline_step_m)));
        for (int k = 0; k < steps; ++k) points.emplace_back(a + side * (k + 0.5) / steps + inward);
    }
    return points;
}

/// The path, and what a robot that came to stand a little later would pass.
std::vector<Pose2> prolonged(std::vector<Pose2> path, const MotionCommand& command, double time_s) {
    const Pose2 end = path.back();
    for (const double share : {0.25, 0.5, 0.75, 1.0})
        path.push_back(compose(end, pose_after(command, share * time_s)));
    return path;
}

}  // namespace

CollisionChecker::CollisionChecker(const RobotModel& robot, const CollisionCheckerParams& params,
                                   double cell_m)
    : robot_(robot),
      params_(params),
      cell_m_(cell_m),
      radius_m_(circumscribed_radius_m(robot.footprint_m)),
      outline_m_(points_around(robot.footprint_m, inside_cells * cell_m)) {}

double CollisionChecker::outline_mps(const MotionCommand& command) const {
    return std::abs(command.v_mps) + std::abs(command.omega_radps) * radius_m_;
}

double CollisionChecker::reach_m(const MotionCommand& motion) const {
    const double fastest_mps = std::max({std::abs(motion.v_mps), robot_.v_max_mps, robot_.v_back_mps});
    const double outline =
        fastest_mps + std::max(robot_.omega_max_radps, std::abs(motion.omega_radps)) * radius_m_;
    return stopping_distance_m(robot_, fastest_mps) + fastest_mps * params_.period_s + 2.0 * radius_m_ +
           params_.touch_m + params_.margin_s * outline;
}

Surroundings CollisionChecker::look(const GroundMemory& ground, double time_s, const Pose2& T_map_robot,
                                    const MotionCommand& motion) const {
    Surroundings now{
        time_s, T_map_robot, plausible_motion(robot_, motion), {}, std::numeric_limits<double>::infinity()};
    const Pose2 T_robot_map = inverse(T_map_robot);
    const Vector2d here(T_map_robot.x_m, T_map_robot.y_m);
    for (const Vector2d& obstacle : ground.obstacles(here, reach_m(now.motion), time_s)) {
        const Vector2d p = transform(T_robot_map, obstacle);
        const double distance_m = signed_distance_m(robot_.footprint_m, p);
        if (ContactRule{}.is_ignored(distance_m)) continue;
        now.obstacles.push_back({p, distance_m});
        if (distance_m > 0.0) now.nearest_m = std::min(now.nearest_m, distance_m);
    }
    return now;
}

/// A fast robot keeps a margin that grows with its speed. A crawling one keeps touch_m, or the distance that
/// it has when an obstacle is nearer already.
ContactRule CollisionChecker::rule_for(const Surroundings& now, const MotionCommand& candidate) const {
    const double touch_m = params_.touch_m + cell_m_ / 2;
    const double fast_mps = outline_mps(candidate) - params_.crawl_mps;
    if (fast_mps > rounding_m)
        return {touch_m + params_.margin_s * fast_mps, -std::numeric_limits<double>::infinity()};
    return {std::min(touch_m, now.nearest_m - rounding_m), rounding_m};
}

bool CollisionChecker::touches(const Surroundings& now, const Pose2& T_robot_then, const ContactRule& rule,
                               Vector2d& where_m) const {
    const Pose2 T_then_robot = inverse(T_robot_then);
    for (const NearObstacle& obstacle : now.obstacles) {
        const Vector2d p = transform(T_then_robot, obstacle.at_m);
        if (p.norm() > radius_m_ + rule.margin_m) continue;
        if (!rule.touches(obstacle.distance_m, signed_distance_m(robot_.footprint_m, p))) continue;
        where_m = obstacle.at_m;
        return true;
    }
    return false;
}

/// True when a longer part of the outline than `most_m` passes over ground for which holds(place_m, map
/// frame) is true, at one of the poses after the first.
template <class Holds>
bool CollisionChecker::holds_under_outline(const Surroundings& now, const std::vector<Pose2>& path,
                                           double most_m, const Holds& holds) const {
    const int most = static_cast<int>(most_m / outline_step_m);
    return std::any_of(path.begin() + 1, path.end(), [&](const Pose2& T_robot_then) {
        const Pose2 T_map_then = compose(now.T_map_robot, T_robot_then);
        int count = 0;
        for (const Vector2d& point : outline_m_) {
            count += holds(transform(T_map_then, point));
            if (count > most) return true;
        }
        return false;
    });
}

Forecast CollisionChecker::forecast(const GroundMemory& ground, const Surroundings& now,
                                    const std::deque<TimedCommand>& sent, const MotionCommand& candidate,
                                    double hold_s) const {
    const std::vector<Pose2> path =
        stopping_path(robot_, now.motion, sent, now.time_s, {now.time_s, candidate}, hold_s);
    const ContactRule rule = rule_for(now, candidate);
    Forecast forecast;
    forecast.touches = std::any_of(path.begin() + 1, path.end(), [&](const Pose2& T_robot_then) {
        return touches(now, T_robot_then, rule, forecast.where_m);
    });
    if (forecast.touches) return forecast;
    const double spare_s = 2.0 * inside_cells * cell_m_ / outline_mps(candidate);
    const std::vector<Pose2> on = prolonged(path, candidate, spare_s);
    const double most_m = params_.unseen_max_m;
    forecast.unseen = holds_under_outline(
        now, on, most_m, [&](const Vector2d& p_m) { return !ground.is_seen(p_m, now.time_s); });
    forecast.unscanned = forecast.unseen && holds_under_outline(now, on, most_m, [&](const Vector2d& p_m) {
                             return !ground.is_seen(p_m, now.time_s) && !ground.is_scanned(p_m, now.time_s);
                         });
    const double margin_s = candidate.v_mps > 0.0 ? unconfirmed_margin_m / candidate.v_mps : 0.0;
    const std::vector<Pose2> farther_on = prolonged(path, candidate, spare_s + margin_s);
    forecast.unconfirmed = holds_under_outline(
        now, farther_on, 0.0, [&](const Vector2d& p_m) { return ground.is_unconfirmed(p_m, now.time_s); });
    const bool may_be_too_fast = !forecast.unseen && candidate.v_mps > params_.unconfirmed_mps;
    forecast.unproven =
        may_be_too_fast && holds_under_outline(now, farther_on, unproven_max_m, [&](const Vector2d& p_m) {
            return !ground.is_confirmed(p_m, now.time_s);
        });
    return forecast;
}

}  // namespace flownav::nav
