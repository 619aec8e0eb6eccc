#pragma once

#include <cstdint>
#include <string>

#include "faults.h"
#include "flownav/drive/simulated_drive.h"

namespace flownav {

/// Options common to all runs.
struct ScenarioOptions {
    drive::SensorKind sensor = drive::SensorKind::Flow;
    bool explain = false;  ///< prints every change of the guard's state
    std::string navigator = "lanes";
    int width_px = 320;
    int height_px = 240;
    double fault_s = 3.0;         ///< how long a fault lasts
    double mover_near_m = 0.8;    ///< minimum distance of the object ahead of the bumper
    double mover_spread_m = 0.8;  ///< random addition to that distance, at most
};

/// One run: a row of the table.
struct RunRow {
    Fault fault = Fault::None;
    std::uint64_t seed = 0;
    std::string outcome;
    double speed_mps = 0.0;   ///< at the start of the fault
    double distance_m = 0.0;  ///< of the object, from the bumper
    double stop_s = -1.0;     ///< from the fault to standstill; < 0: no standstill during the fault
    /// Limit for stop_s: 0.3 s, the delay of a command, and braking; for an object: until it leaves.
    double allowed_s = 0.0;
    double way_m = 0.0;            ///< distance driven until then
    std::string reason = "-";      ///< reason of the guard's first stop after the fault
    double contact_mps = 0.0;      ///< speed of the robot at a collision
    double min_clearance_m = 0.0;  ///< after the start of the fault
    bool drives_on = false;        ///< reached the goal after the fault
    double after_fault_s = -1.0;   ///< time after the fault until the robot moved at half its speed again
    int stops_before = 0;          ///< false alarms: stops of the guard for the sensor, before the fault
    double cpu_s = 0.0;
};

/// Drives through a random lane to a goal 7 m away. A first drive without a fault gives the time of the
/// fault: a random moment of steady driving.
class Scenario {
  public:
    Scenario(const ScenarioOptions& options, std::uint64_t seed);

    /// True when the drive without a fault reached its goal.
    bool is_sound() const { return nominal_.outcome == drive::Outcome::Reached; }
    const drive::DriveResult& nominal() const { return nominal_; }

    RunRow run(Fault fault);

  private:
    drive::SimulatedDriveOptions drive_options() const;
    drive::DriveSample moment_of(Fault fault) const;
    void break_drive(drive::SimulatedDriveOptions& drive, const FaultPlan& plan, const drive::DriveSample& at,
                     RunRow& row) const;

    ScenarioOptions options_;
    std::uint64_t seed_;
    drive::DriveResult nominal_;
};

}  // namespace flownav
