#pragma once
#include <Eigen/Core>
#include <cmath>

namespace flownav {

/// Position and heading on the ground, in metres and radians; x forward, y left, yaw > 0 to the left.
struct Pose2 {
    double x_m = 0.0;
    double y_m = 0.0;
    double yaw_rad = 0.0;
};

inline double wrap_angle(double angle_rad) {
    return std::remainder(angle_rad, 2.0 * M_PI);
}

/// T_a_c = compose(T_a_b, T_b_c).
inline Pose2 compose(const Pose2& a, const Pose2& b) {
    const double c = std::cos(a.yaw_rad);
    const double s = std::sin(a.yaw_rad);
    return {a.x_m + c * b.x_m - s * b.y_m, a.y_m + s * b.x_m + c * b.y_m, wrap_angle(a.yaw_rad + b.yaw_rad)};
}

/// T_b_a from T_a_b.
inline Pose2 inverse(const Pose2& p) {
    const double c = std::cos(p.yaw_rad);
    const double s = std::sin(p.yaw_rad);
    return {-c * p.x_m - s * p.y_m, s * p.x_m - c * p.y_m, -p.yaw_rad};
}

/// Point p_b in frame a, given T_a_b.
inline Eigen::Vector2d transform(const Pose2& T_a_b, const Eigen::Vector2d& p_b) {
    const double c = std::cos(T_a_b.yaw_rad);
    const double s = std::sin(T_a_b.yaw_rad);
    return {T_a_b.x_m + c * p_b.x() - s * p_b.y(), T_a_b.y_m + s * p_b.x() + c * p_b.y()};
}

/// Pose reached from the identity by a turn of `turn_rad` over a CHORD of `chord_m`. The chord points along
/// half the turn (a circular arc) plus `chord_rad` to the left.
inline Pose2 along_arc(double turn_rad, double chord_m, double chord_rad = 0.0) {
    const double direction_rad = turn_rad / 2 + chord_rad;
    return {chord_m * std::cos(direction_rad), chord_m * std::sin(direction_rad), turn_rad};
}

}  // namespace flownav
