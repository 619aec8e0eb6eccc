#pragma once

#include <cstdint>
#include <deque>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"

namespace flownav::sim {

/// A robot with two driven wheels. A command takes effect `delay_s` after it was given and holds until the
/// next one does; speeds follow it at the limits of the model: `accel_mps2` away from standstill,
/// `brake_mps2` toward it, `alpha_radps2` for turns. The motion is integrated in steps of 1 ms along exact
/// arcs, and inside a step pose() follows the same arc: the drive does not depend on when advance() is
/// called.
class Vehicle {
  public:
    Vehicle(RobotModel robot, const Pose2& start);

    /// Gives a command at `time_s`, not before the time reached. Clipped to the speeds of the model. Throws
    /// std::invalid_argument when it is not a number.
    void command(double time_s, const MotionCommand& command);

    /// Moves on to `time_s`; earlier times do nothing.
    void advance(double time_s);

    const Pose2& pose() const { return pose_; }
    MotionCommand motion() const { return motion_; }

  private:
    struct Pending {
        double effect_s;
        MotionCommand command;
    };

    void settle();

    RobotModel robot_;
    std::int64_t steps_ = 0;  ///< whole steps done
    bool settled_ = false;    ///< whether motion_ is that of the step after these
    Pose2 step_pose_;         ///< at the last whole step
    Pose2 pose_;
    MotionCommand motion_;
    MotionCommand wanted_;
    std::deque<Pending> pending_;
};

}  // namespace flownav::sim
