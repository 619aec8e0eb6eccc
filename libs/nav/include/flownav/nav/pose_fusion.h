#pragma once

#include <deque>
#include <optional>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"
#include "flownav/nav/jump_detector.h"

namespace flownav::nav {

/// Where the robot is, from the flow odometry where the sensor measured, from the wheels in between and where
/// it did not. Flow comes late and seldom but does not slip; wheels are always there. Poses are in the frame
/// `map`, whose origin is where the wheels' frame started.
class PoseFusion {
  public:
    /// `start`: pose of the robot in the map when the first odometry arrives. `robot`: how fast it can move.
    explicit PoseFusion(const RobotModel& robot, const Pose2& start = {});

    /// A pose of the wheels, in time order. The first one becomes the origin of their frame; a step that no
    /// robot can make counts as none.
    void odometry(double time_s, const Pose2& T_odom_robot);

    /// Flow odometry of a field; empty: it could not measure. Times rise, at most a second behind the wheels.
    void flow(double time_s, const std::optional<Pose2>& T_start_robot);

    /// The robot now (at the last odometry) and at a time of the last two seconds.
    Pose2 now() const;
    Pose2 at(double time_s) const;

  private:
    struct Stamped {
        double time_s;
        Pose2 pose;
    };

    Pose2 wheels_at(double time_s) const;

    JumpDetector jumps_;
    Pose2 T_map_odom_;
    std::optional<Pose2> T_wheels_odom_;  ///< origin of the wheels' own frame
    std::deque<Stamped> wheels_;          ///< of the last two seconds
    std::optional<Stamped> flow_;         ///< the last flow odometry
};

}  // namespace flownav::nav
