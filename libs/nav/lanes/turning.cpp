#include "turning.h"

#include <algorithm>

namespace flownav::nav {
namespace {

constexpr double turning_radps = 0.1;  // faster, and hardly moving forward: the robot turns on the spot
constexpr double hardly_mps = 0.08;
constexpr double gain_1ps = 2.5;  // omega per remaining angle
constexpr double least_radps = 0.25;

}  // namespace

bool wants_to_turn(const Eigen::Vector2d& waypoint_robot_m, const MotionCommand& motion,
                   const LaneParams& params) {
    const double bearing = bearing_rad(waypoint_robot_m);
    const bool turning = std::abs(motion.v_mps) < hardly_mps && motion.omega_radps * bearing > 0.0 &&
                         std::abs(motion.omega_radps) > turning_radps;
    return std::abs(bearing) > (turning ? params.turned_rad : params.behind_rad);
}

MotionCommand turn_by(const RobotModel& robot, double angle_rad) {
    const double angle = std::abs(angle_rad);
    const double stoppable = 0.8 * std::sqrt(2.0 * robot.alpha_radps2 * angle);
    const double wanted = std::max(least_radps, std::min(gain_1ps * angle, stoppable));
    return {0.0, std::copysign(std::min(wanted, robot.omega_max_radps), angle_rad)};
}

}  // namespace flownav::nav
