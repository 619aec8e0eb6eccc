#include "flownav/sim/vehicle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace flownav::sim {
namespace {

constexpr double steps_per_s = 1000.0;
/// A time that should be a whole number of steps may be a rounding error short of it.
constexpr double rounding_s = 1e-9;

double moved_toward(double from, double to, double change) {
    return from + std::clamp(to - from, -change, change);
}

/// Speed after a step: braked on the way to a standstill, and through it to the other direction speeded up.
double next_speed(double from, double to, const RobotModel& robot) {
    const bool braking = std::abs(to) < std::abs(from) || to * from < 0.0;
    return moved_toward(from, to, (braking ? robot.brake_mps2 : robot.accel_mps2) / steps_per_s);
}

Pose2 moved(const Pose2& from, const MotionCommand& motion, double duration_s) {
    const double turn_rad = motion.omega_radps * duration_s;
    const double half_rad = turn_rad / 2;
    const double chord_per_arc = std::abs(half_rad) < 1e-8 ? 1.0 : std::sin(half_rad) / half_rad;
    return compose(from, along_arc(turn_rad, motion.v_mps * duration_s * chord_per_arc));
}

}  // namespace

Vehicle::Vehicle(RobotModel robot, const Pose2& start)
    : robot_(std::move(robot)), step_pose_(start), pose_(start) {}

void Vehicle::command(double time_s, const MotionCommand& command) {
    if (!std::isfinite(command.v_mps) || !std::isfinite(command.omega_radps))
        throw std::invalid_argument("a vehicle was commanded a speed that is not a number");
    const MotionCommand clipped{
        std::clamp(command.v_mps, -robot_.v_back_mps, robot_.v_max_mps),
        std::clamp(command.omega_radps, -robot_.omega_max_radps, robot_.omega_max_radps)};
    pending_.push_back({time_s + robot_.delay_s, clipped});
}

void Vehicle::advance(double time_s) {
    for (; static_cast<double>(steps_ + 1) / steps_per_s <= time_s + rounding_s; ++steps_) {
        settle();
        step_pose_ = moved(step_pose_, motion_, 1.0 / steps_per_s);
        settled_ = false;
    }
    const double rest_s = time_s - static_cast<double>(steps_) / steps_per_s;
    if (rest_s > rounding_s) {
        settle();
        pose_ = moved(step_pose_, motion_, rest_s);
    } else if (rest_s > -rounding_s) {
        pose_ = step_pose_;
    }
}

/// Fixes the motion of the step that begins. Put off until it is needed: commands at its very beginning
/// count.
void Vehicle::settle() {
    if (settled_) return;
    settled_ = true;
    const double now_s = static_cast<double>(steps_) / steps_per_s;
    for (; !pending_.empty() && pending_.front().effect_s <= now_s + rounding_s; pending_.pop_front())
        wanted_ = pending_.front().command;
    motion_.v_mps = next_speed(motion_.v_mps, wanted_.v_mps, robot_);
    motion_.omega_radps =
        moved_toward(motion_.omega_radps, wanted_.omega_radps, robot_.alpha_radps2 / steps_per_s);
}

}  // namespace flownav::sim
