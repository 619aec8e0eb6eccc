#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <vector>

#include "flownav/core/recycling_queue.h"
#include "flownav/mapping/global_map.h"
#include "flownav/mapping/params.h"

namespace flownav::mapping {

/// Map around the robot, x forward and y left, fused from the sets of the last `memory_s` seconds. Evidence
/// is kept in cells of the MAP's frame: added when a set comes, taken away when it is forgotten. The grid in
/// the robot's frame is redrawn from them, so that it fits the robot's pose at any time.
class LocalMap {
  public:
    explicit LocalMap(const MapParams& params);

    /// Adds a set, forgets what is too old, and redraws the grid around set.T_map_robot. Allocates only while
    /// there is more to remember than ever before. A pose that is not finite, or 1000 km away, changes
    /// nothing.
    void insert(const ObstacleSet& set);

    /// Redraws the grid around a robot that has moved on since the last set.
    void redraw(const Pose2& T_map_robot);

    /// Of cells that lie askew in the map's frame an obstacle may cover two.
    const mrpt::maps::COccupancyGridMap2D& grid() const { return grid_; }

  private:
    /// Sum of evidence on a cell of the map's frame. The array is a ring in both directions: a cell far away
    /// gives its place to a near one.
    struct Cell {
        Eigen::Vector2i index = Eigen::Vector2i::Zero();
        int log_odds = 0;  ///< of being FREE, in thousandths
        int since = 0;     ///< number of the first set it knows of
    };
    struct Entry {
        Eigen::Vector2i index;
        int log_odds;
    };
    struct Remembered {
        double timestamp_s = 0.0;
        int number = 0;
        std::vector<Entry> entries;
    };

    std::size_t place_of(const Eigen::Vector2i& index) const;
    Cell& place(const Eigen::Vector2i& index);
    int log_odds(const Eigen::Vector2i& index) const;
    /// How much it counted: ground that was seen to be free often is no freer than `log_odds_max` says.
    int add(const Entry& entry);
    void forget(const Remembered& old);

    MapParams params_;
    int side_;  ///< cells along the edge of the ring, a power of two
    std::vector<Cell> cells_;
    RecyclingQueue<Remembered> history_;
    std::vector<Evidence> evidence_;         ///< of the newest set
    int sets_ = 0;                           ///< number of the newest one
    std::vector<Eigen::Vector2d> movers_m_;  ///< of the newest set, map frame
    mrpt::maps::COccupancyGridMap2D grid_;
};

}  // namespace flownav::mapping
