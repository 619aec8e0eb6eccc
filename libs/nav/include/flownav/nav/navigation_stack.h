#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "flownav/core/navigation_params.h"
#include "flownav/core/sensor_report.h"
#include "flownav/mapping/local_map.h"
#include "flownav/nav/guard.h"
#include "flownav/nav/pose_fusion.h"
#include "flownav/nav/recovery_manager.h"

namespace flownav::nav {

/// What one field, or one scan, brought.
struct SensorUpdate {
    SensorReport report;  ///< of another sensor: timestamp_s and end_of_cycle only
    bool by_camera = true;
    std::optional<Pose2> T_start_robot;  ///< flow odometry; empty: not measured
    std::vector<ObstaclePoint> points;   ///< robot frame at report.timestamp_s
    std::vector<GroundPatch> ground;     ///< robot frame at report.timestamp_s
};

/// Everything between sensor and motors: pose, maps, recovery manager and guard. Fed with what arrives, in
/// the order in which it arrives, and asked for a command as often as the motors want one. No clock: all
/// times are the caller's. The map's frame is the one `start` was given in.
class NavigationStack {
  public:
    NavigationStack(const NavigationParams& navigation, const mapping::MapParams& map,
                    const GuardParams& guard, RecoveryManager recovery, const Pose2& start);

    using FaultInjection =
        std::function<std::optional<MotionCommand>(double time_s, const MotionCommand& proposed)>;

    /// Pose and motion of the robot as its wheels have it.
    void odometry(double time_s, const Pose2& T_odom_robot, const MotionCommand& motion);

    /// Has just arrived.
    void update(const SensorUpdate& update);

    /// What the motors are to do. The navigator is asked when its period has passed. Times rise. `fault
    /// injection` is for tests: what the guard hears instead of the navigator's proposal, if anything.
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
