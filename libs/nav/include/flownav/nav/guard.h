#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"
#include "flownav/core/sensor_report.h"
#include "flownav/nav/collision_checker.h"
#include "flownav/nav/ground_memory.h"
#include "flownav/nav/guard_params.h"
#include "flownav/nav/guard_reason.h"
#include "flownav/nav/jump_detector.h"
#include "flownav/nav/odometry_watch.h"
#include "flownav/nav/sensor_watch.h"
#include "flownav/nav/stopping_path.h"

namespace flownav::nav {

/// Command for the motors, and the reason when it differs from the proposal.
struct SafetyDecision {
    MotionCommand command;
    GuardAction action = GuardAction::Pass;
    GuardReason reason = GuardReason::None;
    std::string why;  ///< a sentence; empty when the command passed
};

/// Entry of the log: the decision changed.
struct GuardEvent {
    double time_s = 0.0;
    GuardAction action = GuardAction::Pass;
    GuardReason reason = GuardReason::None;
    std::string why;
};

/// Stands between navigator and motors and trusts neither the sensor nor the navigator: lets a command pass
/// only when the robot, told to stop right after it, comes to stand on ground that was seen to be free. All
/// times are of one clock, in seconds, and rise; fields carry their own time stamps, of the same clock.
/// See share/doc/guard.md for every reason, threshold and rule.
class Guard {
  public:
    Guard(const RobotModel& robot, const GuardParams& params);

    /// Takes the report of a processed field.
    void sensed(const SensorReport& report);
    /// Takes a pose of the wheels.
    void odometry(double time_s, const Pose2& T_odom_robot);
    /// A local map (robot frame, probability of being FREE) as of `time_s`, and where the robot was then. To
    /// be called after each cycle of the sensor, of a standing robot too.
    void mapped(const mrpt::maps::COccupancyGridMap2D& local_map, double time_s, const Pose2& T_map_robot);
    /// Takes a contact scan of the record of `time_s`, and where the robot was then. To be called after
    /// mapped() with the map that holds the scan. Without any scan the rules for unconfirmed ground do not
    /// apply.
    void scanned(const ContactScan& scan, double time_s, const Pose2& T_map_robot);
    /// Takes the proposal of the navigator, which is also its heartbeat.
    void proposed(double time_s, const MotionCommand& command);

    /// Returns the command for the motors. `T_map_robot`, `motion`: pose and motion of the robot now.
    SafetyDecision check(double time_s, const Pose2& T_map_robot, const MotionCommand& motion);

    /// The changes so far, at most events_max (the oldest are dropped).
    const std::deque<GuardEvent>& events() const { return events_; }

  private:
    struct Moment {
        double time_s = 0.0;
        Pose2 T_map_robot;
    };

    void note_pose(double time_s, const Pose2& T_map_robot, const MotionCommand& motion);
    Fault fault_now(double time_s);
    Fault held(const Fault& fault, double time_s);
    bool may_turn_out(const Fault& fault, double time_s) const;
    MotionCommand limited() const;
    Fault objection(const Surroundings& now, const MotionCommand& candidate) const;
    bool has_turned_since_scan(const Surroundings& now, const MotionCommand& candidate) const;
    Fault objection_to_unseen(const Forecast& ahead, double fast_mps) const;
    Fault objection_to_speed(const Forecast& ahead, const MotionCommand& candidate) const;
    SafetyDecision allow(const Surroundings& now, const MotionCommand& wanted) const;
    SafetyDecision sent(const Surroundings& now, const SafetyDecision& safety);
    void log(double time_s, const SafetyDecision& safety);

    RobotModel robot_;
    GuardParams params_;
    SensorWatch sensor_;
    OdometryWatch odometry_;
    JumpDetector pose_jumps_;
    GroundMemory ground_;
    CollisionChecker collision_checker_;
    std::optional<TimedCommand> proposal_;
    std::optional<double> map_s_;
    bool has_scans_ = false;                 ///< a contact scan has come
    std::optional<double> scan_yaw_rad_;     ///< heading of the last open one, map frame
    std::optional<Moment> last_;             ///< of the last check()
    std::deque<TimedCommand> sent_;          ///< commands to the motors within the last delay
    double hold_s_;                          ///< longest time that a command is in force
    double jumped_s_ = -1e9;                 ///< when T_map_robot jumped
    Fault holding_;                          ///< why the robot stands
    double fault_s_ = -1e9;                  ///< time of the last fault
    bool probe_wanted_ = false;              ///< the robot must probe before it drives on
    std::optional<double> probing_since_s_;  ///< crawling until flow and wheels agree
    double probe_pause_s_ = 0.0;
    std::optional<double> standing_since_s_;  ///< turning in place counts as standing
    bool over_unseen_ = false;                ///< the last command leads over unseen ground
    double crept_m_ = 0.0;                    ///< way over unseen ground since new ground was seen
    std::deque<GuardEvent> events_;
    std::optional<double> milder_since_s_;  ///< since when the decision is milder than the last event
};

}  // namespace flownav::nav
