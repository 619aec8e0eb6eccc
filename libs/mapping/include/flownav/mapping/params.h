#pragma once

#include "flownav/mapping/occupancy_limits.h"

namespace flownav::mapping {

struct MapParams {
    double resolution_m = 0.1;  ///< edge of a cell
    double size_m = 10.0;       ///< edge of the local map, which keeps the robot at its centre
    double memory_s = 6.0;      ///< the local map forgets evidence older than this
    OccupancyLimits occupancy;
};

}  // namespace flownav::mapping
