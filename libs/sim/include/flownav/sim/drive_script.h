#pragma once

#include <string>

#include "flownav/core/robot_model.h"
#include "flownav/sim/timed_path.h"

namespace flownav::sim {

/// Drives a vehicle by a script: steps separated by ';' or line ends, each of them
///     forward M | back M | left DEG [RADIUS_M] | right DEG [RADIUS_M] | wait S | speed MPS | turn DEGPS
/// Without a radius it turns on the spot. It does not stop between forward and curves. Angles come out
/// exactly, lengths to a millimetre; speed and turn change at the limits of the model, as Vehicle does it, so
/// that the place after a curve is that of one with soft ends. `speed` and `turn` hold for the steps that
/// follow; at first they are v_max_mps and half of omega_max_radps. Throws PathError with the step that goes
/// wrong, or when all of it would last longer than an hour.
TimedPath drive_script(const std::string& script, const RobotModel& robot, const Pose2& start);

}  // namespace flownav::sim
