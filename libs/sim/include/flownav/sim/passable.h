#pragma once

#include "flownav/sim/world.h"

namespace flownav::sim {

/// Whether a disc can move from the start of a world to its goal among the things that do not move and stand
/// below `height_m`, and without a step of the ground beyond step_max_m: searched on a grid of 0.05 m, which
/// needs passages about that much wider than the disc. False without a goal.
bool passable(const World& world, double radius_m, double height_m);

}  // namespace flownav::sim
