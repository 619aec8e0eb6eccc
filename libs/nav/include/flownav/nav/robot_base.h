#pragma once

#include <optional>
#include <stdexcept>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"

namespace flownav::nav {

/// The base cannot be reached or does not obey; what() names the base, the reason and the remedy.
class RobotError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// One reading of the wheel odometry.
struct WheelReading {
    double time_s = 0.0;   ///< in the clock that also stamps the camera's fields
    Pose2 T_odom_robot;    ///< since an arbitrary start: x forward, y left, yaw > 0 to the left
    MotionCommand motion;  ///< current motion
};

/// A robot that flownav drives: derive from it for your own base. share/doc/robot.md has a complete example.
/// odometry() and drive() are called by ONE thread, 20 to 50 times a second, and should return within a few
/// milliseconds; stop() and emergency_stop() may come from ANOTHER thread (the watchdog's) at any time. The
/// base should stop by itself when no drive() came for some 0.3 s. Throw RobotError when the base is lost:
/// this ends the drive.
class RobotBase {
  public:
    RobotBase() = default;
    virtual ~RobotBase() = default;
    RobotBase(const RobotBase&) = delete;
    RobotBase& operator=(const RobotBase&) = delete;

    /// The newest reading since the last call; empty when there is none.
    virtual std::optional<WheelReading> odometry() = 0;

    /// Sets forward speed and turn rate until the next command.
    virtual void drive(const MotionCommand& command) = 0;

    /// Brakes until the robot stands.
    virtual void stop() { drive({}); }

    /// Brakes as hard as the base can.
    virtual void emergency_stop() { stop(); }
};

}  // namespace flownav::nav
