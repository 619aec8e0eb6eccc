#pragma once

#include "flownav/math/footprint.h"

namespace flownav {

/// Forward speed and turn rate (> 0 to the left) of a robot with two driven wheels, commanded or actual.
struct MotionCommand {
    double v_mps = 0.0;
    double omega_radps = 0.0;
};

/// The robot's shape and limits, for planners, guard and simulator. Robot frame: x forward, y left, origin on
/// the ground below the axis the robot turns about.
struct RobotModel {
    /// Outline seen from above, a simple polygon, counter-clockwise.
    Polygon footprint_m = {{0.25, 0.2}, {-0.25, 0.2}, {-0.25, -0.2}, {0.25, -0.2}};
    double height_m = 1.0;     ///< objects above this height cannot be hit
    double v_max_mps = 0.4;    ///< fastest speed forward
    double v_back_mps = 0.15;  ///< fastest speed backward, > 0
    double omega_max_radps = 0.9;
    double accel_mps2 = 0.5;    ///< forward acceleration limit
    double brake_mps2 = 1.0;    ///< forward deceleration limit
    double alpha_radps2 = 2.0;  ///< limit of the change of omega, in both directions
    double delay_s = 0.1;       ///< delay from a command to its effect
};

}  // namespace flownav
