#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "flownav/core/contact_scan.h"
#include "flownav/core/navigation_params.h"
#include "flownav/core/sensor_report.h"
#include "flownav/mapping/local_map.h"
#include "flownav/nav/guard.h"
#include "flownav/nav/pose_fusion.h"
#include "flownav/nav/recovery_manager.h"

namespace flownav::nav {

/// Results of one field, or of one scan.
struct SensorUpdate {
    SensorReport report;  ///< of another sensor: timestamp_s and end_of_cycle only
    bool by_camera = true;
    std::optional<Pose2> T_start_robot;  ///< flow odometry; empty: not measured
    std::vector<ObstaclePoint> points;   ///< robot frame at report.timestamp_s
    std::vector<GroundPatch> ground;     ///< robot frame at report.timestamp_s
    ContactScan contacts = {};           ///< ContactGate::Off: no new scan
};

/// Pose, maps, recovery manager and guard between sensor and motors. Takes readings in the order of their
/// arrival, and gives a command whenever the motors need one. All times are those of the caller. The map has
/// the frame of `start`.
class NavigationStack {
  public:
    NavigationStack(const NavigationParams& navigation, const mapping::MapParams& map,
                    const GuardParams& guard, RecoveryManager recovery, const Pose2& start);

    using FaultInjection =
        std::function<std::optional<MotionCommand>(double time_s, const MotionCommand& proposed)>;

    /// Takes pose and motion of the robot by its wheels.
    void odometry(double time_s, const Pose2& T_odom_robot, const MotionCommand& motion);

    /// Takes a reading that has just arrived.
    void update(const SensorUpdate& update);

    /// Command for the motors. The navigator is asked when its period has passed. Times rise.
    /// `fault_injection` is for tests: it replaces the navigator's proposal unless it returns an empty value.
    MotionCommand command(double time_s, const FaultInjection& fault_injection = {});

    // What it thinks, for logs and pictures.
    Pose2 T_map_robot() const { return pose_.now(); }
    const RecoveryDecision& decision() const { return decision_; }
    const SafetyDecision& safety() const { return safety_; }
    const Guard& guard() const { return guard_; }
    bool just_decided() const { return just_decided_; }
    const mrpt::maps::COccupancyGridMap2D& map() const { return map_.grid(); }
    const mrpt::maps::COccupancyGridMap2D& local_map() const { return local_.grid(); }

  private:
    void decide(double time_s, const FaultInjection& fault_injection);

    NavigationParams params_;
    PoseFusion pose_;
    mapping::LocalMap local_;
    mapping::GlobalMap map_;
    RecoveryManager recovery_;
    Guard guard_;
    MotionCommand motion_;
    RecoveryDecision decision_;
    SafetyDecision safety_;
    std::optional<double> decided_s_;
    bool just_decided_ = false;
};

}  // namespace flownav::nav
