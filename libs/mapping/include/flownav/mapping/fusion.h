#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <vector>

#include "flownav/core/obstacle_point.h"
#include "flownav/core/pose2.h"
#include "flownav/mapping/evidence.h"
#include "flownav/mapping/params.h"

namespace flownav {

/// What one cycle of the sensor saw, and from where.
struct ObstacleSet {
    double timestamp_s = 0.0;
    Pose2 T_map_robot;                  ///< robot pose in the map's frame
    std::vector<ObstaclePoint> points;  ///< robot frame
    std::vector<GroundPatch> ground;    ///< robot frame
};

/// Map of a whole drive: every set fused into one grid in the frame of the start pose.
class DriveMap {
  public:
    explicit DriveMap(const MapParams& params);

    void insert(const ObstacleSet& set);
    const mrpt::maps::COccupancyGridMap2D& grid() const { return grid_; }

  private:
    std::vector<Evidence> evidence_;  ///< of the newest set
    mrpt::maps::COccupancyGridMap2D grid_;
};

}  // namespace flownav
