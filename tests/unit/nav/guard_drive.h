#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cmath>
#include <deque>
#include <functional>
#include <optional>
#include <utility>

#include "flownav/nav/guard.h"
#include "flownav/nav/motion_model.h"

namespace flownav::nav {

/// A robot that follows its model exactly, in steps of 1 ms; independent of the guard's own forecast.
class ModelRobot {
  public:
    explicit ModelRobot(RobotModel robot) : robot_(std::move(robot)) {}

    void command(double time_s, const MotionCommand& command) { commands_.push_back({time_s, command}); }

    void advance(double time_s) {
        while (time_s_ + 5e-4 < time_s) {
            while (!commands_.empty() && commands_.front().time_s + robot_.delay_s <= time_s_ + 5e-4) {
                target_ = commands_.front().command;
                commands_.pop_front();
            }
            const bool brakes =
                std::abs(target_.v_mps) < std::abs(motion_.v_mps) || target_.v_mps * motion_.v_mps < 0;
            const double dv = (brakes ? robot_.brake_mps2 : robot_.accel_mps2) * 1e-3;
            const double dw = robot_.alpha_radps2 * 1e-3;
            motion_.v_mps += std::min(dv, std::max(-dv, target_.v_mps - motion_.v_mps));
            motion_.omega_radps += std::min(dw, std::max(-dw, target_.omega_radps - motion_.omega_radps));
            pose_ = compose(pose_, pose_after(motion_, 1e-3));
            time_s_ += 1e-3;
        }
    }

    double time_s() const { return time_s_; }
    const Pose2& pose() const { return pose_; }
    const MotionCommand& motion() const { return motion_; }
    bool stands() const { return std::abs(motion_.v_mps) + std::abs(motion_.omega_radps) < 1e-3; }

  private:
    RobotModel robot_;
    double time_s_ = 0.0;
    Pose2 pose_;
    MotionCommand motion_;
    MotionCommand target_;
    std::deque<TimedCommand> commands_;
};

/// Input of the guard in one tick; tests inject faults here.
struct Tick {
    double time_s = 0.0;
    SensorReport report;
    bool field = true;
    Pose2 odometry;
    bool odometry_comes = true;
    MotionCommand proposal;
    bool proposal_comes = true;
    mrpt::maps::COccupancyGridMap2D* map = nullptr;  ///< robot frame; empty: no new map
};

inline mrpt::maps::COccupancyGridMap2D known_ground(float p_free = 0.9F) {
    mrpt::maps::COccupancyGridMap2D map(-4.0F, 4.0F, -4.0F, 4.0F, 0.05F);
    map.fill(p_free);
    return map;
}

/// A robot under guard with ideal sensors: fields and guard at 50 Hz, a map every tenth tick.
class Drive {
  public:
    explicit Drive(const GuardParams& params = {}, const RobotModel& robot_model = {})
        : model(robot_model), robot(robot_model), guard(robot_model, params) {}

    /// Continues the drive for `seconds`; `change` may alter each tick before the guard receives it.
    void go(double seconds, const std::function<void(Tick&)>& change = {}) {
        const double end_s = robot.time_s() + seconds;
        while (robot.time_s() + 1e-6 < end_s) tick(change);
    }

    /// Local map in which the cells of `walls` (map frame) are occupied and all others have the value
    /// `elsewhere`.
    mrpt::maps::COccupancyGridMap2D local_map() const {
        mrpt::maps::COccupancyGridMap2D map = known_ground(elsewhere);
        for (const Eigen::Vector2d& wall : walls_m) {
            const Eigen::Vector2d p = transform(inverse(robot.pose()), wall);
            map.setCell(map.x2idx(p.x()), map.y2idx(p.y()), 0.05F);
        }
        return map;
    }

    RobotModel model;
    ModelRobot robot;
    Guard guard;
    MotionCommand wish{0.4, 0.0};
    std::vector<Eigen::Vector2d> walls_m;
    float elsewhere = 0.9F;
    std::function<ContactScan()> scan;  ///< of each cycle; empty: no contact scan
    SafetyDecision safety;

  private:
    void tick(const std::function<void(Tick&)>& change) {
        Tick now;
        now.time_s = robot.time_s();
        now.report = report();
        now.odometry = robot.pose();
        now.proposal = wish;
        std::optional<mrpt::maps::COccupancyGridMap2D> map;
        if (ticks_ % 10 == 0) now.map = &map.emplace(local_map());
        if (change) change(now);
        if (now.odometry_comes) guard.odometry(now.time_s, now.odometry);
        if (now.field) guard.sensed(now.report);
        if (now.map != nullptr) guard.mapped(*now.map, now.time_s, robot.pose());
        if (now.map != nullptr && scan) guard.scanned(scan(), now.time_s, robot.pose());
        if (now.proposal_comes) guard.proposed(now.time_s, now.proposal);
        safety = guard.check(now.time_s, robot.pose(), robot.motion());
        robot.command(now.time_s, safety.command);
        robot.advance(now.time_s + 0.02);
        ++ticks_;
    }

    SensorReport report() {
        SensorReport report;
        report.timestamp_s = robot.time_s();
        report.status = ticks_ == 0 ? FieldStatus::Waiting : FieldStatus::Ok;
        report.end_of_cycle = ticks_ % 10 == 0;
        // Adds the noise of a real camera.
        report.omega_radps = ticks_ == 0 ? 0.0 : wrap_angle(robot.pose().yaw_rad - field_.yaw_rad) / 0.02;
        report.omega_radps += 1e-3 * std::cos(ticks_);
        const Pose2 moved = compose(inverse(cycle_), robot.pose());
        const int fields = ticks_ % 10 == 0 ? 10 : ticks_ % 10;
        report.v_mps = std::copysign(std::hypot(moved.x_m, moved.y_m), moved.x_m) / (0.02 * fields);
        report.v_measured = report.end_of_cycle && std::abs(report.v_mps) > 0.05;
        report.blocks.fill(100);
        report.confident.fill(60);
        field_ = robot.pose();
        if (report.end_of_cycle) cycle_ = robot.pose();
        return report;
    }

    int ticks_ = 0;
    Pose2 field_;
    Pose2 cycle_;
};

}  // namespace flownav::nav
