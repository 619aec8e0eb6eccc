#include "flownav/motion/wheel_track.h"

#include <algorithm>
#include <cmath>

#include "flownav/core/interpolate.h"

namespace flownav::motion {
namespace {

// Standard errors of wheel odometry.
constexpr double way_share = 0.02;
constexpr double turn_share = 0.03;
constexpr double way_floor_m = 0.001;
constexpr double turn_floor_rad = 0.002;
// Change of the motion outside the readings.
constexpr double accel_mps2 = 1.0;
constexpr double alpha_radps2 = 2.0;
// A faster robot does not exist: the wheels were reset.
constexpr double fastest_mps = 50.0;
constexpr double fastest_radps = 20.0;
constexpr double jump_min_m = 0.5;
constexpr double jump_min_rad = 0.5;

bool is_finite(const WheelPose& r) {
    return std::isfinite(r.timestamp_s + r.T_odom_robot.x_m + r.T_odom_robot.y_m + r.T_odom_robot.yaw_rad);
}

bool is_jump(const WheelPose& before, const WheelPose& now) {
    const double dt_s = now.timestamp_s - before.timestamp_s;
    const Pose2 moved = compose(inverse(before.T_odom_robot), now.T_odom_robot);
    return std::hypot(moved.x_m, moved.y_m) > jump_min_m + fastest_mps * dt_s ||
           std::abs(moved.yaw_rad) > jump_min_rad + fastest_radps * dt_s;
}

}  // namespace

double chord_m(const Pose2& T_from_to) {
    return std::copysign(std::hypot(T_from_to.x_m, T_from_to.y_m), T_from_to.x_m);
}

void WheelTrack::note(const WheelPose& reading) {
    if (!is_finite(reading)) return;
    if (!readings_.empty()) {
        if (reading.timestamp_s <= newest_s()) return;
        if (is_jump(readings_.back(), reading)) readings_.clear();
    }
    readings_.push(reading);
}

std::optional<WheelTrack::Interpolated> WheelTrack::at(double time_s) const {
    if (readings_.size() < 2) return std::nullopt;
    const auto is_before = [time_s](const WheelPose& r) { return r.timestamp_s < time_s; };
    const std::size_t later = readings_.partition_point(is_before);
    const double outside_s =
        std::max({0.0, readings_.front().timestamp_s - time_s, time_s - readings_.back().timestamp_s});
    if (outside_s > extrapolation_s) return std::nullopt;
    const std::size_t to = std::clamp<std::size_t>(later, 1, readings_.size() - 1);
    const WheelPose& a = readings_[to - 1];
    const WheelPose& b = readings_[to];
    const double share = (time_s - a.timestamp_s) / (b.timestamp_s - a.timestamp_s);
    return Interpolated{interpolated(a.T_odom_robot, b.T_odom_robot, share), outside_s};
}

bool WheelTrack::pauses_between(double from_s, double to_s) const {
    const auto is_until = [from_s](const WheelPose& r) { return r.timestamp_s <= from_s; };
    std::size_t i = std::max<std::size_t>(readings_.partition_point(is_until), 1);
    for (; i < readings_.size(); ++i) {
        if (readings_[i].timestamp_s - readings_[i - 1].timestamp_s > pause_max_s) return true;
        if (readings_[i].timestamp_s >= to_s) break;
    }
    return false;
}

std::optional<WheelMotion> WheelTrack::between(double from_s, double to_s) const {
    const auto from = at(from_s);
    const auto to = at(to_s);
    if (!from || !to || !(from_s <= to_s) || pauses_between(from_s, to_s)) return std::nullopt;
    WheelMotion motion;
    motion.T_from_to = compose(inverse(from->T_odom_robot), to->T_odom_robot);
    const double outside_s = std::hypot(from->outside_s, to->outside_s);
    const double guessed_m = 0.5 * accel_mps2 * outside_s * outside_s;
    const double guessed_rad = 0.5 * alpha_radps2 * outside_s * outside_s;
    motion.sigma_forward_m =
        std::hypot(way_share * chord_m(motion.T_from_to), std::hypot(way_floor_m, guessed_m));
    motion.sigma_turn_rad =
        std::hypot(turn_share * motion.T_from_to.yaw_rad, std::hypot(turn_floor_rad, guessed_rad));
    return motion;
}

}  // namespace flownav::motion
