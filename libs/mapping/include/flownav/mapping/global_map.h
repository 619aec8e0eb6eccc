#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <vector>

#include "flownav/mapping/evidence.h"
#include "flownav/mapping/obstacle_set.h"
#include "flownav/mapping/params.h"
#include "flownav/mapping/rim_memory.h"

namespace flownav::mapping {

/// Map of a whole drive: every set fused into one grid in the frame of the start pose. It reaches at most
/// 1000 m, or 10000 cells, from the start in each direction: a broken odometry must not eat the memory.
class GlobalMap {
  public:
    explicit GlobalMap(const MapParams& params);

    /// Fuses a set, unless the robot stood outside the largest map; then it is counted and left out.
    void insert(const ObstacleSet& set);
    const mrpt::maps::COccupancyGridMap2D& grid() const { return grid_; }

    int sets() const { return sets_; }                  ///< that were inserted,
    int sets_outside() const { return sets_outside_; }  ///< and how many of these were left out
    double half_m() const { return half_m_; }           ///< half the edge of the largest map

  private:
    double half_m_;
    int sets_ = 0;
    int sets_outside_ = 0;
    std::vector<Evidence> evidence_;  ///< of the newest set
    RimMemory rims_;
    mrpt::maps::COccupancyGridMap2D grid_;
};

}  // namespace flownav::mapping
