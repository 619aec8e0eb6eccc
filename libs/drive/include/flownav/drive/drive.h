#pragma once

#include <Eigen/Core>
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
    Reached,    ///< the goal, or the length of way that was asked for
    Blocked,    ///< no way was found
    Collision,  ///< something was touched; only a simulation knows
    Timeout,    ///< the time was over
    Stopped,    ///< told to stop
    Lost        ///< base, camera or program failed
};

/// The word of an outcome, as result files have it.
const char* to_string(Outcome outcome);

struct DriveOptions {
    config::Config config;  ///< sections [map] and [navigation]
    nav::GuardParams guard;
    Pose2 start;                                      ///< in the frame of the goals
    std::vector<Eigen::Vector2d> goals_m;             ///< the last one is the goal
    std::optional<Eigen::Vector2d> waypoint_robot_m;  ///< instead: a way point fixed in the robot's frame
    double timeout_s = 120.0;
    double way_max_m = 1e9;        ///< the drive is over (Reached) after so much way; for waypoint_robot_m
    double tick_s = 0.02;          ///< of wheels, guard and motors
    std::string navlog_directory;  ///< empty: none
    double hung_s = 0.0;  ///< > 0: a thread stops the base when the loop hangs for so long; for real robots
    std::function<bool()> stop_wanted;               ///< asked every tick; empty: never
    nav::NavigationStack::FaultInjection navigator;  ///< for tests: what the navigator proposes instead
};

/// One control tick, in the frame of the goals where nothing else is said.
struct DriveSample {
    double time_s = 0.0;  ///< since the start of the drive
    Pose2 T_world_robot;  ///< truth; a simulation has it
    bool truth_known = false;
    Pose2 T_map_robot;  ///< as the robot believes
    Pose2 odometry;     ///< wheels alone, T_odom_robot
    MotionCommand motion;
    MotionCommand proposed;
    MotionCommand command;
    double clearance_m = 0.0;  ///< true distance to the nearest thing; with truth_known
};

struct DriveResult {
    Outcome outcome = Outcome::Timeout;
    std::string why;  ///< what was touched, why it is blocked, what was lost
    double time_s = 0.0;
    double path_m = 0.0;                 ///< true way in a simulation, believed way otherwise
    double min_clearance_m = 0.0;        ///< of a simulation
    double contact_speed_mps = 0.0;      ///< of a collision
    std::vector<nav::GuardEvent> stops;  ///< and slow-downs; times since the start of the drive
    std::vector<DriveSample> samples;
};

/// Who watches a drive; every function does nothing unless it is overridden. on_field() comes in the thread
/// that works on the fields, all others in the one that drives.
class DriveObserver {
  public:
    DriveObserver() = default;
    virtual ~DriveObserver() = default;
    DriveObserver(const DriveObserver&) = delete;
    DriveObserver& operator=(const DriveObserver&) = delete;

    virtual void on_field(const Field&, const pipeline::Step&) {}
    virtual void on_odometry(double /*timestamp_s*/, const Pose2& /*T_odom_robot*/) {}
    virtual void on_truth(double /*timestamp_s*/, const Pose2& /*T_world_robot*/) {}
    virtual void on_decision(const DriveSample&, const nav::NavigationStack&) {}
    virtual void on_tick(const DriveSample&) {}
    virtual void on_end(const nav::NavigationStack&) {}
};

/// Knows the truth about the drive, as a simulation does.
class Witness {
  public:
    struct Truth {
        Pose2 T_world_robot;
        MotionCommand motion;
        double clearance_m = 0.0;
        std::string touched;  ///< what the robot touches; empty: nothing
        bool at_goal = false;
    };

    Witness() = default;
    virtual ~Witness() = default;
    Witness(const Witness&) = delete;
    Witness& operator=(const Witness&) = delete;

    /// `last_goal`: all way points but the goal have been reached.
    virtual Truth truth(double time_s, bool last_goal) = 0;
};

/// The parts of a robot that a drive is made with.
struct DrivenRobot {
    Clock& clock;
    nav::RobotBase& base;
    SensorFeed& feed;
    Witness* witness = nullptr;  ///< null: nobody knows the truth
};

/// Drives a robot, simulated or real, to its goal, tick by tick. Whatever happens, and whatever base, sensor
/// or observer throw, the base is told to stop at the end and the result says what happened. Throws only
/// before the robot moves: std::invalid_argument for options that make no sense.
DriveResult drive(const DriveOptions& options, const DrivenRobot& robot, DriveObserver& observer);

}  // namespace flownav::drive
