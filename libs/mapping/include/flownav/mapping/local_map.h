#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Geometry>
#include <vector>

#include "flownav/core/recycling_queue.h"
#include "flownav/mapping/global_map.h"
#include "flownav/mapping/params.h"
#include "flownav/mapping/rim_memory.h"
#include "flownav/math/rolling_grid.h"

namespace flownav::mapping {

/// Map around the robot, x forward and y left, fused from the sets of the last `memory_s` seconds. Keeps the
/// evidence in cells of the MAP's frame, adds that of a new set, subtracts that of an expired set, and draws
/// the grid in the robot's frame from these cells. Rims of drops do not expire: see RimMemory.
class LocalMap {
  public:
    explicit LocalMap(const MapParams& params);

    /// Adds a set, removes sets older than memory_s, and redraws the grid around set.T_map_robot. Allocates
    /// only when a set is larger, or more sets are in memory, than ever before. Ignores the set when its pose
    /// is not finite or 1000 km or more from the origin.
    void insert(const ObstacleSet& set);

    /// Redraws the grid around a robot that has moved on since the last set.
    void redraw(const Pose2& T_map_robot);

    /// Grid in the robot frame. A rotated cell of the map frame may cover two of its cells.
    const mrpt::maps::COccupancyGridMap2D& grid() const { return grid_; }

  private:
    /// Sums of the evidence for one cell of the map's frame: log odds of being FREE, in thousandths.
    struct Sum {
        int told = 0;   ///< that it is free, or occupied
        int doubt = 0;  ///< evidence toward unknown: of the other sign, and not more than what is told
        int since = 0;  ///< number of the first set in the sums

        int log_odds() const { return told + doubt; }
    };
    struct Entry {
        Eigen::Vector2i cell;
        int log_odds;
        bool is_doubt;
    };
    struct Remembered {
        double timestamp_s = 0.0;
        int number = 0;
        std::vector<Entry> entries;
    };

    int log_odds(const Eigen::Vector2i& cell) const;
    void note_movers(const ObstacleSet& set);
    void draw_rims(const Eigen::Isometry2d& T_robot_map);
    /// Adds evidence to its cell, as far as the limits let it, and returns how much was added.
    int add(const Evidence& e);
    static void add_to(Sum& sum, bool is_doubt, int log_odds);
    void forget(const Remembered& old);

    MapParams params_;
    RollingGrid<Sum> cells_;  ///< map frame
    RecyclingQueue<Remembered> history_;
    RimMemory rims_;
    std::vector<Evidence> evidence_;         ///< of the newest set
    int sets_ = 0;                           ///< number of the newest one
    std::vector<Eigen::Vector2d> movers_m_;  ///< of the newest cycle, map frame
    mrpt::maps::COccupancyGridMap2D grid_;
};

}  // namespace flownav::mapping
