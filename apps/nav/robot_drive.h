#pragma once

#include <functional>
#include <string>
#include <vector>

#include "flownav/nav/robot_base.h"
#include "simulated_drive.h"

namespace flownav {

/// What the sensor of a robot has to say; filled by a camera's thread, or by a test.
class SensorFeed {
  public:
    SensorFeed() = default;
    virtual ~SensorFeed() = default;
    SensorFeed(const SensorFeed&) = delete;
    SensorFeed& operator=(const SensorFeed&) = delete;

    /// Everything that arrived since the last call, in its order. Never waits.
    virtual std::vector<nav::Sensed> arrived() = 0;

    /// Why nothing will ever arrive again; empty: more may come.
    virtual std::string end() = 0;
};

struct RobotDriveOptions {
    Config config;
    nav::GuardParams guard;
    Pose2 start;  ///< in the frame of the goals
    std::vector<Eigen::Vector2d> goals_m;
    std::optional<Eigen::Vector2d> waypoint_robot_m;  ///< instead of goals: fixed in the robot's frame
    double timeout_s = 120.0;
    double tick_s = 0.02;
    std::string navlog_directory;
    std::function<double()> clock_s;           ///< now; that of wheel readings and fields
    std::function<void(double)> wait_until_s;  ///< returns at that time of the clock, or soon after
};

struct RobotDriveResult {
    Outcome outcome = Outcome::Timeout;
    std::string why;
    double time_s = 0.0;
    double path_m = 0.0;
    std::vector<nav::GuardEvent> stops;
};

/// The pilot of a configuration.
nav::Pilot make_pilot(const Config& config, const std::vector<Eigen::Vector2d>& goals_m,
                      const std::optional<Eigen::Vector2d>& waypoint_robot_m,
                      const std::string& navlog_directory);

/// Drives a real robot to its goal, tick by tick. The robot is told to stop at the end, whatever happened.
/// Throws RobotError when the base is lost.
RobotDriveResult drive_robot(const RobotDriveOptions& options, nav::RobotBase& robot, SensorFeed& feed);

}  // namespace flownav
