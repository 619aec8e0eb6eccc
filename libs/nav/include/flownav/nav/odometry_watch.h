#pragma once

#include <deque>
#include <optional>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"
#include "flownav/core/sensor_report.h"
#include "flownav/nav/guard_params.h"
#include "flownav/nav/guard_reason.h"
#include "flownav/nav/jump_detector.h"

namespace flownav::nav {

/// Compares the motion by flow with the motion by the wheels.
class OdometryWatch {
  public:
    OdometryWatch(const RobotModel& robot, const OdometryWatchParams& params)
        : params_(params),
          jumps_(robot, params.jump_m, params.jump_rad),
          radius_m_(circumscribed_radius_m(robot.footprint_m)) {}

    void odometry(double time_s, const Pose2& T_odom_robot);
    void sensed(const SensorReport& report);
    /// Fault at `time_s`. Forgets readings that are dated in the future.
    Fault fault(double time_s);

    /// True when flow and wheels agreed about a motion that both measured, after `since_s`.
    bool is_confirmed_since(double since_s) const;

  private:
    struct Stamped {
        double time_s = 0.0;
        Pose2 pose;
    };
    /// One motion by flow and by the wheels.
    struct Pair {
        double begin_s = 0.0;
        double end_s = 0.0;
        double flow = 0.0;
        double wheels = 0.0;
    };

    std::optional<Pose2> wheels_between(double from_s, double to_s) const;
    std::optional<Pose2> wheels_at(double time_s) const;
    void forget_before(double time_s);
    void forget_future(double time_s);
    void compare_turn(const SensorReport& report);
    void compare_way(const SensorReport& report);
    void count_repeated(const SensorReport& report);
    Fault contradiction(const std::deque<Pair>& pairs, double free, double share, const char* what) const;

    OdometryWatchParams params_;
    JumpDetector jumps_;
    double radius_m_;
    std::deque<Stamped> wheels_;
    std::deque<Pair> turns_;
    std::deque<Pair> ways_;
    std::optional<SensorReport> last_;  ///< of the last field
    std::optional<double> cycle_s_;     ///< when the running cycle began
    int repeated_fields_ = 0;           ///< in a row
    double repeated_way_m_ = 0.0;       ///< of the outline meanwhile, by the wheels
    double jumped_s_ = -1e9;
    double newest_s_ = -1e9;  ///< odometry
};

}  // namespace flownav::nav
