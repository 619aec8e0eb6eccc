#pragma once

#include "flownav/nav/lanes.h"

namespace flownav::nav {

/// What the cells of the map say about a lane; near, score and open are left at their defaults.
LaneView look_along(const LaneTables& tables, const Lane& lane, const std::vector<CellKind>& kinds,
                    const LaneParams& params);

/// How far a lane of that free way may be driven, and how near that leads to the way point: 1 reaches it, 0
/// gains nothing.
double nearness(const LaneView& view, const Eigen::Vector2d& waypoint_m, const LaneParams& params);

/// How far the robot can turn on the spot, in radians.
double free_turn_rad(const std::vector<LaneCell>& turn, const std::vector<CellKind>& kinds);

/// Weighs a lane, whose `near` is known.
double score(const LaneTables& tables, const LaneView& view, const MotionCommand& motion,
             const LaneParams& params);

}  // namespace flownav::nav
