#pragma once

#include "flownav/core/pose2.h"
#include "flownav/core/virtual_scan.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

/// An ideal 2D lidar above the axis the robot turns about: exact ranges, all beams at one instant. Its plane
/// is level, also on a ramp.
struct LidarParams {
    double height_m = 0.3;  ///< of its plane above the ground of the axis
    double field_of_view_deg = 270.0;
    int beams = 541;  ///< >= 2, from the right end of the field of view to the left
    double range_max_m = 8.0;
    double rate_hz = 20.0;  ///< for those who call scan(); it has no effect there
};

/// What the lidar sees: Obstacle with the range of the first solid, or Free up to range_max_m. Beams start at
/// the lidar, bearings are the robot's. Throws std::invalid_argument on params that make no sense.
VirtualScan scan(const World& world, const LidarParams& params, const Pose2& T_world_robot, double time_s);

}  // namespace flownav::sim
