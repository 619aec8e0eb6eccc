#include "flownav/sim/wheel_odometry.h"

#include <cmath>

namespace flownav::sim {

Pose2 WheelOdometry::update(const Pose2& T_world_robot) {
    if (!T_world_robot_) {
        T_world_robot_ = T_world_robot;
        T_odom_robot_ = T_world_robot;
        return T_odom_robot_;
    }
    const Pose2 moved = compose(inverse(*T_world_robot_), T_world_robot);
    T_world_robot_ = T_world_robot;
    const double turn_rad = wrap_angle(moved.yaw_rad);
    const double backward = moved.x_m < 0.0 ? -1.0 : 1.0;
    const double chord_m = backward * std::hypot(moved.x_m, moved.y_m);
    const double way_m =
        chord_m * params_.scale + random_.normal(params_.way_noise_m * std::sqrt(std::abs(chord_m)));
    const double heading_rad =
        turn_rad * params_.turn_scale +
        random_.normal(params_.turn_noise_rad * std::sqrt(std::abs(chord_m) + std::abs(turn_rad)));
    T_odom_robot_ = compose(T_odom_robot_, along_arc(heading_rad, way_m));
    return T_odom_robot_;
}

}  // namespace flownav::sim
