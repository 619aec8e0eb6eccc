#pragma once

#include "flownav/nav/lanes.h"

namespace flownav::nav {

/// What the cells of the map say about a lane; near, score and open are left at their defaults.
LaneView look_along(const LaneTables& tables, const Lane& lane, const std::vector<CellKind>& kinds,
                    const LaneParams& params);

/// What driving along a lane within the horizon gains: 1 as much as can be, 0 nothing, < 0 leads away.
double nearness(const LaneView& view, const Eigen::Vector2d& waypoint_m, const LaneParams& params);

/// How far the robot can turn on the spot, in radians.
double free_turn_rad(const std::vector<LaneCell>& turn, const std::vector<CellKind>& kinds);

/// Weighs a lane, whose `near` is known.
double score(const LaneTables& tables, const LaneView& view, const MotionCommand& motion,
             const LaneParams& params);

}  // namespace flownav::nav
