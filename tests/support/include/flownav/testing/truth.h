#pragma once
#include "flownav/core/ego_motion.h"
#include "flownav/core/pose2.h"
#include "flownav/sim/truth.h"
#include "flownav/testing/upright.h"

namespace flownav::testing {

using sim::exact_flow;
using sim::floor_index;
using sim::FlowTruth;
using sim::look;
using sim::project;
using sim::Sight;
using sim::View;

/// Exact motion between two poses, as the sensor reports it: turn, and the chord along half the turn.
EgoMotion exact_motion(const Pose2& from, const Pose2& to);

/// The same with the turn about the camera's x axis, from the pitch of the two mounts.
EgoMotion exact_motion(const View& from, const View& to);

}  // namespace flownav::testing
