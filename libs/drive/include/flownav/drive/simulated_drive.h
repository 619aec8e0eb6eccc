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

/// Faults to inject into a drive. Empty functions inject none.
struct DriveFaults {
    std::function<std::optional<Field>(const Field&)> field;  ///< returns the altered field; empty: dropped
    std::function<double(double time_s)> field_delay_s;       ///< added to the sensor's latency
    std::function<Pose2(double time_s, const Pose2&)> odometry;
};

/// Keys of the camera in `config` are not used, see `camera`. `start` and `goals_m` are in the world frame.
struct SimulatedDriveOptions : DriveOptions {
    sim::World world;
    SensorKind sensor = SensorKind::Flow;
    sim::CameraSimParams camera;
    sim::LidarParams lidar;
    sim::OdometryParams odometry;
    double success_radius_m = 0.5;  ///< true distance that counts as reached
    double latency_s = 0.04;        ///< from the time of a field to its result
    bool realtime = false;          ///< limits the simulation to real time
    DriveFaults faults;
};

/// Drives the simulated robot to its goal. Deterministic. Sets MRPT's clock to simulated time while it runs.
DriveResult simulate_drive(const SimulatedDriveOptions& options, DriveObserver& observer);

}  // namespace flownav::drive
