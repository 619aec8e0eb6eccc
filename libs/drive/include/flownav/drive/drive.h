#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/field.h"
#include "flownav/drive/clock.h"
#include "flownav/drive/sensor_feed.h"
#include "flownav/nav/navigation_stack.h"
#include "flownav/nav/robot_base.h"

namespace flownav::drive {

enum class Outcome {
    Reached,    ///< at the goal, or `way_max_m` was driven
    Blocked,    ///< no way was found
    Collision,  ///< the robot touched an obstacle; only of a simulation
    Fell,       ///< the robot's outline was over an edge of its ground; only of a simulation
    Timeout,    ///< time limit exceeded
    Stopped,    ///< stop_wanted() returned true
    Lost        ///< base or camera failed, or an exception was thrown
};

/// Returns the word for an outcome that result files use.
const char* to_string(Outcome outcome);

struct DriveOptions {
    config::Config config;                 ///< sections [map], [navigation] and [guard]
    Pose2 start;                           ///< in the frame of the goals
    std::vector<Eigen::Vector2d> goals_m;  ///< the last one is the goal
    /// Replaces `goals_m`: a way point fixed in the robot's frame.
    std::optional<Eigen::Vector2d> waypoint_robot_m;
    double timeout_s = 120.0;
    double way_max_m = 1e9;        ///< length after which the drive ends as Reached; for waypoint_robot_m
    double tick_s = 0.02;          ///< period of wheels, guard and motors
    std::string navlog_directory;  ///< empty: none
    /// > 0: a watchdog thread stops the base when the loop hangs for this long; for real robots.
    double hung_s = 0.0;  ///< > 0: a thread stops the base when a tick takes longer; for real robots
    std::function<bool()> stop_wanted;               ///< polled every tick; empty: never stops
    nav::NavigationStack::FaultInjection navigator;  ///< for tests: replaces the navigator's proposal
};

/// One control tick; poses are in the frame of the goals unless stated otherwise.
struct DriveSample {
    double time_s = 0.0;  ///< since the start of the drive
    Pose2 T_world_robot;  ///< true pose; valid when truth_known
    bool truth_known = false;
    Pose2 T_map_robot;  ///< estimate of the robot
    Pose2 odometry;     ///< T_odom_robot of the wheels
    MotionCommand motion;
    MotionCommand proposed;
    MotionCommand command;
    double clearance_m = 0.0;  ///< true distance to the nearest obstacle; valid when truth_known
    /// True height and tilt of the robot in the frame that T_world_robot has on the plane z = 0.
    Eigen::Isometry3d T_flat_robot = Eigen::Isometry3d::Identity();
};

struct DriveResult {
    Outcome outcome = Outcome::Timeout;
    std::string why;  ///< the touched obstacle, or the reason of the outcome; empty: reached
    double time_s = 0.0;
    double path_m = 0.0;           ///< length of the true way in a simulation, of the estimated way otherwise
    double min_clearance_m = 0.0;  ///< simulation only
    double contact_speed_mps = 0.0;      ///< simulation only, after a collision or a fall
    std::vector<nav::GuardEvent> stops;  ///< stops and slow-downs; times since the start of the drive
    std::vector<DriveSample> samples;
};

/// Is told of the events of a drive; the default functions are empty. on_field() is called in the thread that
/// processes the fields, all others in the thread of the control loop.
class DriveObserver {
  public:
    DriveObserver() = default;
    virtual ~DriveObserver() = default;
    DriveObserver(const DriveObserver&) = delete;
    DriveObserver& operator=(const DriveObserver&) = delete;

    virtual void on_field(const Field&, const pipeline::Step&) {}
    virtual void on_odometry(double /*timestamp_s*/, const Pose2& /*T_odom_robot*/) {}
    /// `T_flat_robot`: height and tilt on the ground, see DriveSample.
    virtual void on_truth(double /*timestamp_s*/, const Pose2& /*T_world_robot*/,
                          const Eigen::Isometry3d& /*T_flat_robot*/) {}
    virtual void on_decision(const DriveSample&, const nav::NavigationStack&) {}
    virtual void on_tick(const DriveSample&) {}
    virtual void on_end(const nav::NavigationStack&) {}
};

/// Returns the true state of the robot; implemented by a simulation.
class Witness {
  public:
    struct Truth {
        Pose2 T_world_robot;
        MotionCommand motion;
        double clearance_m = 0.0;
        std::string touched;  ///< name of the touched obstacle; empty when the robot is free
        std::string fell;     ///< place and depth of the edge the robot is over; empty when it stands
        Eigen::Isometry3d T_flat_robot = Eigen::Isometry3d::Identity();  ///< height and tilt on the ground
        bool at_goal = false;
    };

    Witness() = default;
    virtual ~Witness() = default;
    Witness(const Witness&) = delete;
    Witness& operator=(const Witness&) = delete;

    /// `last_goal`: all way points but the goal have been reached.
    virtual Truth truth(double time_s, bool last_goal) = 0;
};

/// The parts of a robot that drive() needs; they must outlive the drive.
struct DrivenRobot {
    Clock& clock;
    nav::RobotBase& base;
    SensorFeed& feed;
    Witness* witness = nullptr;  ///< null: the truth is unknown
};

/// Drives a robot, simulated or real, to its goal, tick by tick. Stops the base at the end, also when base,
/// sensor or observer throw; the outcome is Lost then. Throws std::invalid_argument, before the robot moves,
/// for options that contradict each other.
DriveResult drive(const DriveOptions& options, const DrivenRobot& robot, DriveObserver& observer);

}  // namespace flownav::drive
