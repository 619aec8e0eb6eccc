#include "flownav/sim/vehicle.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "flownav/core/unicycle.h"

namespace flownav::sim {
namespace {

constexpr double steps_per_s = 1000.0;
constexpr double step_s = 1.0 / steps_per_s;
/// Tolerance for times that are a whole number of steps but for rounding.
constexpr double rounding_s = 1e-9;

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
        step_pose_ = compose(step_pose_, pose_after(motion_, step_s));
        settled_ = false;
    }
    const double rest_s = time_s - static_cast<double>(steps_) / steps_per_s;
    if (rest_s > rounding_s) {
        settle();
        pose_ = compose(step_pose_, pose_after(motion_, rest_s));
    } else if (rest_s > -rounding_s) {
        pose_ = step_pose_;
    }
}

/// Computes the motion of the step that begins. Called as late as possible, so that a command given at the
/// beginning of the step takes effect in it.
void Vehicle::settle() {
    if (settled_) return;
    settled_ = true;
    const double now_s = static_cast<double>(steps_) / steps_per_s;
    for (; !pending_.empty() && pending_.front().effect_s <= now_s + rounding_s; pending_.pop_front())
        wanted_ = pending_.front().command;
    motion_ = motion_after(robot_, motion_, wanted_, step_s);
}

}  // namespace flownav::sim
