#pragma once

#include <deque>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"

namespace flownav::nav {

struct TimedCommand {
    double time_s = 0.0;
    MotionCommand command;
};

/// Poses of a robot that moves with `motion` at `time_s`, is given `candidate` for `hold_s` and then a stop,
/// until it stands. Commands of `sent` (in time order) that are not older than the delay take effect first.
/// Poses are in the robot frame of `time_s`, the first one is the identity; from one to the next a point of
/// the footprint moves at most about `step_m`.
std::vector<Pose2> stopping_path(const RobotModel& robot, const MotionCommand& motion,
                                 const std::deque<TimedCommand>& sent, double time_s,
                                 const TimedCommand& candidate, double hold_s, double step_m = 0.02);

}  // namespace flownav::nav
