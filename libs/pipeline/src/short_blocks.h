#pragma once
#include <Eigen/Core>
#include <vector>

#include "reconstruct.h"

namespace flownav::pipeline {

/// Blocks whose vectors are shorter than those of the floor: what they show lies below it.
struct ShortBlocks {
    std::vector<Eigen::Vector2d>
        floor_points_m;            ///< where floor would be: (forward, right) from the newest camera
    std::vector<double> sorted_m;  ///< buffer of obstacles::mark_drops()
};

/// Fills `out.floor_points_m` with the short blocks of an ended cycle within obstacles::drop_range_m.
void find_short_blocks(const EndedCycle& cycle, ShortBlocks& out);

}  // namespace flownav::pipeline
