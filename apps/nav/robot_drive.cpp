#include "robot_drive.h"

#include <cmath>

#include "flownav/nav/make_navigator.h"
#include "flownav/nav/watchdog.h"

namespace flownav {
namespace {

constexpr double hung_s = 1.0;  // whatever hangs, the navigator or anything else of the loop

void stop_quietly(nav::RobotBase& robot) {
    try {
        robot.stop();
    } catch (const nav::RobotError&) {
        // A base that is lost stops by itself.
    }
}

/// Tells the robot to stop when it goes, also for an exception.
class StopAtTheEnd {
  public:
    explicit StopAtTheEnd(nav::RobotBase& robot) : robot_(robot) {}
    ~StopAtTheEnd() { stop_quietly(robot_); }
    StopAtTheEnd(const StopAtTheEnd&) = delete;
    StopAtTheEnd& operator=(const StopAtTheEnd&) = delete;

  private:
    nav::RobotBase& robot_;
};

}  // namespace

nav::Pilot make_pilot(const Config& config, const std::vector<Eigen::Vector2d>& goals_m,
                      const std::optional<Eigen::Vector2d>& waypoint_robot_m,
                      const std::string& navlog_directory) {
    const NavigationParams& navigation = config.navigation;
    nav::NavigatorOptions navigator;
    navigator.kind = navigation.navigator;
    navigator.robot = navigation.robot;
    navigator.period_s = navigation.decide_every_s;
    navigator.map_size_m = config.map.size_m;
    navigator.resolution_m = config.map.resolution_m;
    navigator.navlog_dir = navlog_directory;
    if (waypoint_robot_m) return {navigation.robot, nav::make_navigator(navigator), *waypoint_robot_m};
    nav::PilotParams pilot;
    pilot.plan = navigation.plan;
    pilot.goal_radius_m = navigation.goal_radius_m;
    return {navigation.robot, pilot, nav::make_navigator(navigator), goals_m};
}

RobotDriveResult drive_robot(const RobotDriveOptions& options, nav::RobotBase& robot, SensorFeed& feed) {
    nav::Autopilot autopilot(
        options.config.navigation, options.config.map, options.guard,
        make_pilot(options.config, options.goals_m, options.waypoint_robot_m, options.navlog_directory),
        options.start);
    const StopAtTheEnd stop(robot);
    nav::Watchdog watchdog([&robot] { stop_quietly(robot); });
    watchdog.start_watchdog(hung_s);
    const double began_s = options.clock_s();
    RobotDriveResult result;
    Pose2 last = options.start;
    for (int tick = 1;; ++tick) {
        const double now_s = options.clock_s();
        watchdog.alive();
        if (const auto reading = robot.odometry())
            autopilot.odometry(reading->time_s, reading->T_odom_robot, reading->motion);
        for (const nav::Sensed& sensed : feed.arrived()) autopilot.sensed(sensed);
        robot.drive(autopilot.command(now_s));
        const Pose2 pose = autopilot.T_map_robot();
        result.path_m += std::hypot(pose.x_m - last.x_m, pose.y_m - last.y_m);
        last = pose;
        result.time_s = now_s - began_s;
        const nav::PilotDecision& decision = autopilot.decision();
        const auto& events = autopilot.guard().events();
        result.stops.assign(events.begin(), events.end());
        result.why = decision.why;
        if (decision.state == nav::PilotState::Arrived) result.outcome = Outcome::Reached;
        if (decision.state == nav::PilotState::Blocked) result.outcome = Outcome::Blocked;
        if (result.outcome != Outcome::Timeout) return result;
        if (const std::string end = feed.end(); !end.empty()) result.why = end;
        if (!feed.end().empty() || result.time_s >= options.timeout_s) return result;
        options.wait_until_s(began_s + tick * options.tick_s);
    }
}

}  // namespace flownav
