#pragma once

#include <functional>
#include <optional>

#include "flownav/drive/drive.h"
#include "flownav/sim/camera_simulator.h"
#include "flownav/sim/lidar.h"
#include "flownav/sim/wheel_odometry.h"
#include "flownav/sim/world.h"

namespace flownav::drive {

enum class SensorKind { Flow, Lidar };

/// What goes wrong in a drive, on purpose. Empty functions: nothing.
struct DriveFaults {
    std::function<std::optional<Field>(const Field&)> field;  ///< altered, or empty: dropped
    std::function<double(double time_s)> field_delay_s;       ///< added to the sensor's latency
    std::function<Pose2(double time_s, const Pose2&)> odometry;
};

/// `config`: the camera's keys are not used, see `camera`; `start` and `goals_m` are in the world.
struct SimulatedDriveOptions : DriveOptions {
    sim::World world;
    SensorKind sensor = SensorKind::Flow;
    sim::CameraSimParams camera;
    sim::LidarParams lidar;
    sim::OdometryParams odometry;
    double success_radius_m = 0.5;  ///< reached when this near in truth
    double latency_s = 0.04;        ///< from a field to what the pipeline makes of it
    bool realtime = false;          ///< not faster than the clock
    DriveFaults faults;
};

/// Drives the simulated robot to its goal. Deterministic: the same options, the same drive. Sets MRPT's clock
/// to simulated time while it runs.
DriveResult simulate_drive(const SimulatedDriveOptions& options, DriveObserver& observer);

}  // namespace flownav::drive
