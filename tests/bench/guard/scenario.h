#pragma once

#include <cstdint>
#include <string>

#include "faults.h"
#include "flownav/drive/simulated_drive.h"

namespace flownav {

/// What is asked of every run.
struct ScenarioOptions {
    drive::SensorKind sensor = drive::SensorKind::Flow;
    bool explain = false;  ///< every change of the guard goes to the console
    NavigatorKind navigator = NavigatorKind::Lanes;
    int width_px = 320;
    int height_px = 240;
    double fault_s = 3.0;         ///< how long a fault lasts
    double mover_near_m = 0.8;    ///< the mover steps in so far ahead of the bumper, at least,
    double mover_spread_m = 0.8;  ///< and so much farther at the most
};

/// One run, as the table has it.
struct RunRow {
    Fault fault = Fault::None;
    std::uint64_t seed = 0;
    std::string outcome;
    double speed_mps = 0.0;    ///< when the fault began
    double distance_m = 0.0;   ///< of the mover, from the bumper
    double stop_s = -1.0;      ///< from the fault to standing; < 0: it did not stand while the fault lasted
    double allowed_s = 0.0;    ///< 0.3 s, the delay of a command, and braking; mover: until it leaves
    double way_m = 0.0;        ///< meanwhile
    std::string reason = "-";  ///< of the guard's first stop after the fault
    double contact_mps = 0.0;  ///< speed of the robot at a contact
    double min_clearance_m = 0.0;  ///< from the fault on
    bool drives_on = false;        ///< it reached the goal afterwards
    double after_fault_s = -1.0;   ///< until it moved at half its speed again
    int stops_before = 0;          ///< false alarms: stops of the guard for the sensor, before the fault
    double cpu_s = 0.0;
};

/// Drives through a lane drawn from the seed to a goal 7 m away; what happens without any fault says when
/// one begins: at a random time of steady driving.
class Scenario {
  public:
    Scenario(const ScenarioOptions& options, std::uint64_t seed);

    /// The drive without a fault reached its goal, so that there is something to break.
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
