#include "flownav/nav/motion_model.h"

#include <algorithm>
#include <cmath>

namespace flownav::nav {

double stopping_distance_m(const RobotModel& robot, double v_mps) {
    const double v = std::abs(v_mps);
    return v * robot.delay_s + v * v / (2.0 * robot.brake_mps2);
}

double stoppable_speed_mps(const RobotModel& robot, double free_m) {
    const double lag = robot.brake_mps2 * robot.delay_s;
    return std::sqrt(lag * lag + 2.0 * robot.brake_mps2 * std::max(0.0, free_m)) - lag;
}

}  // namespace flownav::nav
