#pragma once

#include <string>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

struct Clearance {
    double distance_m = 0.0;  ///< infinite in an empty world
    std::string nearest;      ///< name of the nearest solid or piece of ground
};

/// Distance, seen from above, between the outline of a robot and the nearest solid that has a part between
/// 0.02 m and the robot's height above the ground of its axis; lower things are driven over, higher ones
/// passed below. Steps of the ground that lead up by more than step_max_m count as solids; edges that lead
/// down do not, see overhang(). <= 0: contact, where the amount only says roughly how deep. Exact for any
/// simple footprint, also one with notches; see plan_view.h for tilted cylinders. Costs 10 to 20 us with
/// hundreds of solids.
Clearance clearance(const World& world, const RobotModel& robot, const Pose2& T_world_robot, double time_s);

}  // namespace flownav::sim
