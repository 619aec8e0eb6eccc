#pragma once
#include "flownav/core/pose2.h"
#include "flownav/sim/world.h"

namespace flownav::testing {

/// How a robot on four sprung wheels stands on uneven ground.
struct Ride {
    double heave_m = 0.0;
    double pitch_rad = 0.0;  ///< > 0 looks down
};

Ride ride_over(const sim::World& world, const Pose2& T_world_robot);

}  // namespace flownav::testing
