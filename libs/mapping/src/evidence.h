#pragma once

#include <vector>

#include "flownav/mapping/global_map.h"
#include "flownav/math/grid2d.h"

namespace flownav::mapping {

/// Probability of being free of a cell that a mover was seen in: it will be elsewhere in the next cycle, so
/// that one sight must do.
constexpr double p_free_of_mover = 0.2;

/// Everything a set says about the cells of a frame, in the order of the cells; movers are left out.
/// T_frame_robot: where the set was seen from.
void gather_evidence(const ObstacleSet& set, const Pose2& T_frame_robot, const GridFrame& frame,
                     std::vector<Evidence>& evidence);

}  // namespace flownav::mapping
