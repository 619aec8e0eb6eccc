#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <vector>

#include "flownav/core/obstacle_point.h"
#include "flownav/core/pose2.h"
#include "flownav/mapping/evidence.h"
#include "flownav/mapping/params.h"

namespace flownav::mapping {

/// What one cycle of the sensor saw, and from where.
struct ObstacleSet {
    double timestamp_s = 0.0;
    Pose2 T_map_robot;                  ///< robot pose in the map's frame
    std::vector<ObstaclePoint> points;  ///< robot frame
    std::vector<GroundPatch> ground;    ///< robot frame
};

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
    mrpt::maps::COccupancyGridMap2D grid_;
};

}  // namespace flownav::mapping
