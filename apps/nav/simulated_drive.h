#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "flownav/nav/autopilot.h"
#include "flownav/pipeline/step.h"
#include "flownav/sensor/config.h"
#include "flownav/sim/camera_simulator.h"
#include "flownav/sim/lidar.h"
#include "flownav/sim/wheel_odometry.h"
#include "flownav/sim/world.h"

namespace flownav {

enum class SensorKind { Flow, Lidar };

enum class Outcome { Reached, Blocked, Collision, Timeout };

/// The word of an outcome, as result files have it.
const char* to_string(Outcome outcome);

/// What goes wrong in a drive, on purpose. Empty functions: nothing.
struct DriveFaults {
    std::function<std::optional<Field>(const Field&)> field;  ///< altered, or empty: dropped
    std::function<double(double time_s)> field_delay_s;       ///< added to the sensor's latency
    std::function<Pose2(double time_s, const Pose2&)> odometry;
    nav::Autopilot::Tamper navigator;  ///< what it proposes instead; empty: it hangs
};

struct SimulatedDriveOptions {
    sim::World world;
    Config config;  ///< the camera's keys are not used: see `camera`
    SensorKind sensor = SensorKind::Flow;
    sim::CameraSimParams camera;
    sim::LidarParams lidar;
    sim::OdometryParams odometry;
    nav::GuardParams guard;
    Pose2 start;                                      ///< in the world
    std::vector<Eigen::Vector2d> goals_m;             ///< in the world; the last one is the goal
    std::optional<Eigen::Vector2d> waypoint_robot_m;  ///< instead: a way point fixed in the robot's frame
    double success_radius_m = 0.5;                    ///< reached when this near in truth
    double timeout_s = 120.0;
    double way_max_m = 1e9;        ///< the drive is over (Reached) after so much way; for waypoint_robot_m
    double latency_s = 0.04;       ///< from a field to what the pipeline makes of it
    std::string navlog_directory;  ///< empty: none
    DriveFaults faults;
};

/// One control tick, in the world's frame where nothing else is said.
struct DriveSample {
    double time_s = 0.0;
    Pose2 T_world_robot;
    Pose2 T_map_robot;  ///< as the robot believes; the map's frame is the world's
    Pose2 odometry;     ///< wheels alone
    MotionCommand motion;
    MotionCommand proposed;
    MotionCommand command;
    double clearance_m = 0.0;
};

struct DriveResult {
    Outcome outcome = Outcome::Timeout;
    std::string why;  ///< what was touched, or why it is blocked
    double time_s = 0.0;
    double path_m = 0.0;
    double min_clearance_m = 0.0;
    double contact_speed_mps = 0.0;      ///< of a collision
    std::vector<nav::GuardEvent> stops;  ///< and slow-downs
    std::vector<DriveSample> samples;
};

/// Who watches a drive; every function does nothing unless it is overridden.
class DriveObserver {
  public:
    DriveObserver() = default;
    virtual ~DriveObserver() = default;
    DriveObserver(const DriveObserver&) = delete;
    DriveObserver& operator=(const DriveObserver&) = delete;

    virtual void on_field(const Field&, const pipeline::Step&) {}
    virtual void on_odometry(double /*timestamp_s*/, const Pose2& /*T_odom_robot*/) {}
    virtual void on_truth(double /*timestamp_s*/, const Pose2& /*T_world_robot*/) {}
    virtual void on_decision(const DriveSample&, const nav::Autopilot&) {}
    virtual void on_tick(const DriveSample&) {}
};

/// Drives the simulated robot to its goal. Deterministic: the same options, the same drive. Sets MRPT's clock
/// to simulated time while it runs.
DriveResult simulate_drive(const SimulatedDriveOptions& options, DriveObserver& observer);

}  // namespace flownav
