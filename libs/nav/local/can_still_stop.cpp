#include "can_still_stop.h"

#include <algorithm>
#include <cmath>

#include "contact_rule.h"
#include "flownav/nav/motion_model.h"
#include "rollout.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double step_s = 0.05;

/// Distance of the footprint to the nearest obstacle that the rule does not ignore, at most the field's
/// reach.
double nearest_m(const FootprintField& field, const std::vector<Vector2d>& obstacles_m,
                 const ContactRule& rule) {
    double least_m = field.reach_m();
    for (const Vector2d& p : obstacles_m) {
        const double distance_m = field.distance_m(p);
        if (!rule.is_ignored(distance_m)) least_m = std::min(least_m, distance_m);
    }
    return least_m;
}

bool touches(const FootprintField& field, const std::vector<Vector2d>& obstacles_m,
             const Pose2& T_robot_there, const ContactRule& rule) {
    const Pose2 T_there_robot = inverse(T_robot_there);
    return std::any_of(obstacles_m.begin(), obstacles_m.end(), [&](const Vector2d& p) {
        const double distance_m = field.distance_m(transform(T_there_robot, p));
        return distance_m < rule.margin_m && rule.touches(field.distance_m(p), distance_m);
    });
}

}  // namespace

std::vector<Vector2d> obstacles_near(const mrpt::maps::COccupancyGridMap2D& map,
                                     const std::vector<CellKind>& kinds, double within_m) {
    std::vector<Vector2d> obstacles_m;
    const auto columns = static_cast<int>(map.getSizeX());
    for (int i = 0; i < static_cast<int>(kinds.size()); ++i) {
        if (kinds[static_cast<std::size_t>(i)] != CellKind::Occupied) continue;
        const Vector2d p(map.idx2x(i % columns), map.idx2y(i / columns));
        if (p.squaredNorm() < within_m * within_m) obstacles_m.push_back(p);
    }
    return obstacles_m;
}

double reach_m(const RobotModel& robot, const FootprintField& field, const LaneParams& params) {
    // stopping_distance_m() holds the delay of the command; added are its period and the delay of the stop.
    return stopping_distance_m(robot, robot.v_max_mps) + robot.v_max_mps * (params.period_s + robot.delay_s) +
           field.radius_m();
}

bool can_still_stop(const RobotModel& robot, const FootprintField& field,
                    const std::vector<Vector2d>& obstacles_m, const MotionCommand& motion,
                    const MotionCommand& command, const LaneParams& params) {
    const ContactRule wanted{params.stop_margin_m};
    const ContactRule rule = wanted.beside(nearest_m(field, obstacles_m, wanted));
    const double stop_s = robot.delay_s + params.period_s + robot.delay_s;
    const auto command_at = [&](double time_s) -> std::optional<MotionCommand> {
        if (time_s >= stop_s) return {};
        return time_s < robot.delay_s ? motion : command;
    };
    bool is_free = true;
    rollout(robot, motion, step_s, command_at, [&](const RolloutStep& step) {
        is_free = !touches(field, obstacles_m, step.T_start_robot, rule);
        return is_free;
    });
    return is_free;
}

}  // namespace flownav::nav
