#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <deque>
#include <vector>

#include "flownav/core/obstacle_point.h"
#include "flownav/core/pose2.h"
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
    mrpt::maps::COccupancyGridMap2D grid_;
};

/// Map around the robot, x forward and y left, fused from the sets of the last `memory_s` seconds after
/// moving each by the motion since. Rebuilt from that history, so that rolling and forgetting need no code of
/// their own.
class LocalMap {
  public:
    explicit LocalMap(const MapParams& params);

    /// Adds a set, forgets what is too old, and redraws the grid around set.T_map_robot.
    void insert(const ObstacleSet& set);

    /// Redraws the grid around a robot that has moved on since the last set.
    void redraw(const Pose2& T_map_robot);
    const mrpt::maps::COccupancyGridMap2D& grid() const { return grid_; }

  private:
    MapParams params_;
    std::deque<ObstacleSet> history_;
    mrpt::maps::COccupancyGridMap2D grid_;
};

}  // namespace flownav
