#include "rollout.h"

#include <algorithm>
#include <cmath>

#include "flownav/nav/motion_model.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double step_s = 0.05;
constexpr double longest_s = 10.0;  // any robot stands by then
constexpr double nearer_m = 0.003;  // accuracy of the footprint's raster
constexpr double least_margin_m = 0.02;
constexpr double under_m = 0.06;

double toward(double value, double target, double up, double down) {
    const bool slower = std::abs(target) < std::abs(value) || target * value < 0.0;
    const double change = slower ? down : up;
    return value + std::clamp(target - value, -change, change);
}

MotionCommand after_step(const RobotModel& robot, const MotionCommand& now, const MotionCommand& wanted) {
    return {toward(now.v_mps, wanted.v_mps, robot.accel_mps2 * step_s, robot.brake_mps2 * step_s),
            toward(now.omega_radps, wanted.omega_radps, robot.alpha_radps2 * step_s,
                   robot.alpha_radps2 * step_s)};
}

bool touches(const FootprintField& field, const std::vector<Vector2d>& obstacles_m,
             const Pose2& T_robot_there, double margin_m) {
    const Pose2 T_there_robot = inverse(T_robot_there);
    return std::any_of(obstacles_m.begin(), obstacles_m.end(), [&](const Vector2d& p) {
        const double distance_m = field.distance_m(transform(T_there_robot, p));
        if (distance_m >= margin_m) return false;
        const double first_m = field.distance_m(p);
        return first_m > -under_m && distance_m < first_m - nearer_m;
    });
}

/// The margin, or less where something stands nearer already.
double margin_here_m(const FootprintField& field, const std::vector<Vector2d>& obstacles_m, double margin_m) {
    double least_m = margin_m;
    for (const Vector2d& p : obstacles_m) {
        const double distance_m = field.distance_m(p);
        if (distance_m > -under_m) least_m = std::min(least_m, distance_m - nearer_m);
    }
    return std::min(margin_m, std::max(least_margin_m, least_m));
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
    // The robot goes on for the delay of the command, its period, and the delay of the stop; the first of
    // these is part of the stopping distance.
    return stopping_distance_m(robot, robot.v_max_mps) + robot.v_max_mps * (params.period_s + robot.delay_s) +
           field.radius_m();
}

bool can_still_stop(const RobotModel& robot, const FootprintField& field,
                    const std::vector<Vector2d>& obstacles_m, const MotionCommand& motion,
                    const MotionCommand& command, const LaneParams& params) {
    const double margin_m = margin_here_m(field, obstacles_m, params.stop_margin_m);
    MotionCommand now = motion;
    Pose2 pose;
    const double told_s = robot.delay_s;
    const double stop_s = told_s + params.period_s + robot.delay_s;
    for (int i = 0; i * step_s < longest_s; ++i) {
        const double t = i * step_s;
        const MotionCommand before = now;
        if (t >= told_s) now = after_step(robot, now, t < stop_s ? command : MotionCommand{});
        const MotionCommand mean{(before.v_mps + now.v_mps) / 2, (before.omega_radps + now.omega_radps) / 2};
        if (t >= stop_s && mean.v_mps == 0.0 && mean.omega_radps == 0.0) break;
        pose = compose(pose, pose_after(mean, step_s));
        if (touches(field, obstacles_m, pose, margin_m)) return false;
    }
    return true;
}

}  // namespace flownav::nav
