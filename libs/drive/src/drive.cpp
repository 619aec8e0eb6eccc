#include "flownav/drive/drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "flownav/nav/make_navigator.h"
#include "flownav/nav/watchdog.h"

namespace flownav::drive {
namespace {

nav::RecoveryManager make_recovery_manager(const DriveOptions& options) {
    const NavigationParams& navigation = options.config.navigation;
    nav::NavigatorOptions navigator;
    navigator.robot = navigation.robot;
    navigator.period_s = navigation.controller_period_s;
    navigator.map_size_m = options.config.map.size_m;
    navigator.resolution_m = options.config.map.resolution_m;
    navigator.lanes.limits = options.config.map.occupancy;
    navigator.navlog_dir = options.navlog_directory;
    nav::RecoveryParams recovery = options.config.recovery;
    recovery.limits = options.config.map.occupancy;
    if (options.waypoint_robot_m)
        return {navigation.robot, recovery, nav::make_navigator(navigation.navigator, navigator),
                *options.waypoint_robot_m};
    return {navigation.robot, recovery, nav::make_navigator(navigation.navigator, navigator),
            options.goals_m};
}

/// Calls `stop` and ignores exceptions: a lost base stops by itself.
template <class Stop>
void quietly(const Stop& stop) {
    try {
        stop();
    } catch (const std::exception&) {
        // The drive is already over.
    }
}

double distance_m(const Pose2& a, const Pose2& b) {
    return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

bool is_finite(const nav::WheelReading& r) {
    return std::isfinite(r.time_s + r.T_odom_robot.x_m + r.T_odom_robot.y_m + r.T_odom_robot.yaw_rad +
                         r.motion.v_mps + r.motion.omega_radps);
}

/// The loop of wheels, sensor, navigation stack and motors.
class Loop {
  public:
    Loop(const DriveOptions& options, const DrivenRobot& robot, DriveObserver& observer)
        : options_(options),
          robot_(robot),
          observer_(observer),
          stack_(options.config.navigation, options.config.map, options.config.guard,
                 make_recovery_manager(options), options.start) {
        result_.min_clearance_m = std::numeric_limits<double>::infinity();
    }

    DriveResult result() {
        try {
            run();
        } catch (const std::exception& error) {
            end(Outcome::Lost, error.what());
        }
        quietly([this] { robot_.base.stop(); });
        observer_.on_end(stack_);
        for (const nav::GuardEvent& event : stack_.guard().events()) {
            result_.stops.push_back(event);
            result_.stops.back().time_s -= began_s_;
        }
        return std::move(result_);
    }

  private:
    void run() {
        std::optional<nav::Watchdog> watchdog;
        if (options_.hung_s > 0.0) {
            watchdog.emplace([this] { quietly([this] { robot_.base.emergency_stop(); }); });
            watchdog->start_watchdog(options_.hung_s);
        }
        began_s_ = robot_.clock.now_s();
        for (int tick = 1; !over_; ++tick) {
            if (watchdog) watchdog->alive();
            control(robot_.clock.now_s());
            if (!over_) robot_.clock.wait_until_s(began_s_ + tick * options_.tick_s);
        }
    }

    void control(double now_s) {
        // Readings that are not finite or have a future time stamp are dropped; the guard treats them as
        // missing.
        const double latest_s = now_s + options_.config.guard.sensor.ahead_s;
        const auto reading = robot_.base.odometry();
        if (reading && is_finite(*reading) && reading->time_s <= latest_s) {
            wheels_ = *reading;
            observer_.on_odometry(reading->time_s, reading->T_odom_robot);
            stack_.odometry(reading->time_s, reading->T_odom_robot, reading->motion);
            robot_.feed.odometry(*reading);
        }
        for (const nav::SensorUpdate& update : robot_.feed.arrived())
            if (update.report.timestamp_s <= latest_s) stack_.update(update);
        const MotionCommand command = stack_.command(now_s, options_.navigator);
        robot_.base.drive(command);
        note(now_s, command);
        judge(now_s);
    }

    void note(double now_s, const MotionCommand& command) {
        DriveSample sample;
        sample.time_s = now_s - began_s_;
        sample.T_map_robot = stack_.T_map_robot();
        sample.odometry = wheels_.T_odom_robot;
        sample.motion = wheels_.motion;
        sample.proposed = stack_.decision().command;
        sample.command = command;
        if (robot_.witness) {
            truth_ = robot_.witness->truth(now_s, stack_.decision().last_goal);
            sample.truth_known = true;
            sample.T_world_robot = truth_.T_world_robot;
            sample.motion = truth_.motion;
            sample.clearance_m = truth_.clearance_m;
            sample.T_flat_robot = truth_.T_flat_robot;
            result_.min_clearance_m = std::min(result_.min_clearance_m, truth_.clearance_m);
        }
        const Pose2& pose = sample.truth_known ? sample.T_world_robot : sample.T_map_robot;
        if (!result_.samples.empty()) result_.path_m += distance_m(pose, last_);
        last_ = pose;
        result_.samples.push_back(sample);
        observer_.on_tick(sample);
        if (stack_.just_decided()) observer_.on_decision(sample, stack_);
    }

    void judge(double now_s) {
        result_.time_s = now_s - began_s_;
        const nav::RecoveryDecision& decision = stack_.decision();
        const std::string sensor_end = robot_.feed.end();
        if (!truth_.touched.empty()) {
            end(Outcome::Collision, "touched " + truth_.touched);
            result_.contact_speed_mps = std::abs(truth_.motion.v_mps);
        } else if (!truth_.fell.empty()) {
            end(Outcome::Fell, "over an edge at " + truth_.fell);
            result_.contact_speed_mps = std::abs(truth_.motion.v_mps);
        } else if (is_at_goal() || result_.path_m >= options_.way_max_m) {
            end(Outcome::Reached, "");
        } else if (decision.state == nav::RecoveryState::Blocked) {
            end(Outcome::Blocked, decision.why);
        } else if (!sensor_end.empty()) {
            end(Outcome::Lost, sensor_end);
        } else if (options_.stop_wanted && options_.stop_wanted()) {
            end(Outcome::Stopped, "told to stop");
        } else if (result_.time_s >= options_.timeout_s - options_.tick_s / 2) {
            end(Outcome::Timeout, decision.why);
        }
    }

    /// By ground truth when there is a witness, by the estimated pose otherwise.
    bool is_at_goal() const {
        if (robot_.witness) return truth_.at_goal;
        return stack_.decision().state == nav::RecoveryState::Arrived;
    }

    void end(Outcome outcome, std::string why) {
        result_.outcome = outcome;
        result_.why = std::move(why);
        over_ = true;
    }

    const DriveOptions& options_;
    const DrivenRobot& robot_;
    DriveObserver& observer_;
    nav::NavigationStack stack_;
    double began_s_ = 0.0;
    nav::WheelReading wheels_;  ///< newest reading
    Pose2 last_;                ///< previous pose, for path_m
    Witness::Truth truth_;
    bool over_ = false;
    DriveResult result_;
};

}  // namespace

const char* to_string(Outcome outcome) {
    constexpr std::array<const char*, 7> words = {"reached", "blocked", "collision", "fell",
                                                  "timeout", "stopped", "lost"};
    return words[static_cast<std::size_t>(outcome)];
}

DriveResult drive(const DriveOptions& options, const DrivenRobot& robot, DriveObserver& observer) {
    return Loop(options, robot, observer).result();
}

}  // namespace flownav::drive
