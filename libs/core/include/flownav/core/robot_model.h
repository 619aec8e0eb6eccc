#pragma once

#include "flownav/math/footprint.h"

namespace flownav {

/// What a robot with two driven wheels is told, or does: forward speed and turn (> 0 to the left).
struct MotionCommand {
    double v_mps = 0.0;
    double omega_radps = 0.0;
};

/// The robot as planners, guard and simulator know it. Robot frame: x forward, y left, origin on the ground
/// below the axis the robot turns about.
struct RobotModel {
    /// Outline seen from above, a simple polygon, counter-clockwise.
    Polygon footprint_m = {{0.25, 0.2}, {-0.25, 0.2}, {-0.25, -0.2}, {0.25, -0.2}};
    double height_m = 1.0;     ///< what hangs higher cannot be hit
    double v_max_mps = 0.4;    ///< fastest speed forward
    double v_back_mps = 0.15;  ///< fastest speed backward, > 0
    double omega_max_radps = 0.9;
    double accel_mps2 = 0.5;    ///< when speeding up
    double brake_mps2 = 1.0;    ///< when slowing down
    double alpha_radps2 = 2.0;  ///< change of omega, either way
    double delay_s = 0.1;       ///< from a command to its effect
};

}  // namespace flownav
