#include "speed_limiter.h"

#include <algorithm>
#include <cmath>

#include "flownav/nav/motion_model.h"
#include "lanes/turning.h"
#include "local/can_still_stop.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double least_way_m = 0.02;
constexpr double look_m = 3.0;
// MRPT keeps nothing free at the sides of its paths; lanes do.
constexpr double more_margin_m = 0.02;
constexpr double stands_mps = 0.1;       // fast enough to turn on the spot
constexpr double unseen_depth_m = 0.05;  // of the smallest patch of unseen ground that counts

CollisionFreeParams free_way_of(const LaneParams& params) {
    CollisionFreeParams collision_free_distance;
    collision_free_distance.limits = params.limits;
    collision_free_distance.length_m = look_m;
    collision_free_distance.margin_m = params.stop_margin_m + more_margin_m;
    collision_free_distance.bumper_m = params.bumper_m;
    collision_free_distance.unseen_area_m2 = params.unseen_area_m2;
    return collision_free_distance;
}

}  // namespace

SpeedLimiter::SpeedLimiter(const RobotModel& robot, const LaneParams& params, double period_s)
    : robot_(robot),
      params_(params),
      free_way_(free_way_of(params)),
      field_(robot.footprint_m, params.stop_margin_m + 0.08) {
    params_.period_s = period_s;
    params_.stop_margin_m += more_margin_m;
}

bool SpeedLimiter::wants_to_turn(const Vector2d& waypoint_robot_m, const MotionCommand& motion) const {
    return nav::wants_to_turn(waypoint_robot_m, motion, params_);
}

Decision SpeedLimiter::turn_to(const Situation& situation, const Vector2d& waypoint_robot_m) const {
    if (std::abs(situation.motion.v_mps) > stands_mps) return {{}, 0.0, false, "stops to turn"};
    const double bearing = bearing_rad(waypoint_robot_m);
    for (const double angle : {bearing, bearing - std::copysign(2.0 * M_PI, bearing)}) {
        const MotionCommand command = turn_by(robot_, angle);
        const CollisionFreeDistance way =
            collision_free_distance(field_, *situation.local_map, command, free_way_);
        if (way.occupied >= std::min(std::abs(angle), 3.0))
            return {command, 0.0, false, "turns to the way point"};
    }
    return {{}, 0.0, true, "there is no room to turn"};
}

Decision SpeedLimiter::limit(const Situation& situation, const MotionCommand& command) const {
    const auto& map = *situation.local_map;
    const CollisionFreeDistance way = collision_free_distance(field_, map, command, free_way_);
    const bool drives = std::abs(command.v_mps) > 1e-3;
    Decision decision{command, drives ? way.occupied : 0.0, false, "drives"};
    double v_mps = std::abs(command.v_mps);
    const auto at_most = [&](double limit_mps, const char* why) {
        if (limit_mps >= v_mps) return;
        v_mps = limit_mps;
        decision.why = why;
    };
    if (drives) {
        at_most(stoppable_speed_mps(robot_, way.occupied - params_.standoff_m), "slows for an obstacle");
        if (way.unseen < way.occupied) {
            at_most(std::max(params_.unseen_mps,
                             stoppable_speed_mps(robot_, way.unseen - params_.bumper_m - unseen_depth_m)),
                    "slows for unseen ground");
        }
        const double share = v_mps / std::abs(command.v_mps);
        decision.command = {share * command.v_mps, share * command.omega_radps};
    }
    const auto obstacles_m =
        obstacles_near(map, kinds_of(map, params_.limits), reach_m(robot_, field_, params_));
    for (const double share : {1.0, 0.5, 0.2}) {
        const MotionCommand slower{share * decision.command.v_mps, share * decision.command.omega_radps};
        if (!can_still_stop(robot_, field_, obstacles_m, situation.motion, slower, params_)) continue;
        decision.command = slower;
        decision.stuck = drives && way.occupied < least_way_m;
        if (decision.stuck) decision.why = "an obstacle is right ahead";
        return decision;
    }
    return {{}, way.occupied, std::abs(situation.motion.v_mps) < 0.02, "stops for an obstacle"};
}

}  // namespace flownav::nav
