#pragma once

#include "flownav/nav/lanes.h"

namespace flownav::nav {

/// Evaluates a lane on the cells of the map; near, score and open keep their defaults.
LaneView look_along(const LaneTables& tables, const Lane& lane, const std::vector<CellKind>& kinds,
                    const LaneParams& params);

/// Gain toward the way point along a lane within the horizon: 1 the largest possible, 0 none, < 0 leads away.
double nearness(const LaneView& view, const Eigen::Vector2d& waypoint_m, const LaneParams& params);

/// Angle that the robot can turn on the spot, radians; at most pi.
double free_turn_rad(const std::vector<LaneCell>& turn, const std::vector<CellKind>& kinds);

/// Weighted score of a lane; `near` must be set.
double score(const LaneTables& tables, const LaneView& view, const MotionCommand& motion,
             const LaneParams& params);

}  // namespace flownav::nav
