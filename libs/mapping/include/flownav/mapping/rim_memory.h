#pragma once

#include <Eigen/Core>
#include <vector>

#include "flownav/mapping/evidence.h"
#include "flownav/mapping/obstacle_set.h"
#include "flownav/math/grid2d.h"

namespace flownav::mapping {

/// Probability of being free of a cell that holds a rim: below every limit of OccupancyLimits.
constexpr double p_free_of_rim = 0.05;

/// Cell of the map frame in which the floor ends.
struct Rim {
    Eigen::Vector2i cell;
    double seen_from_m = 0.0;  ///< the least distance of the robot that the drop was seen from
    int floor_sights = 0;      ///< sets in which the cell was floor, since the drop was last seen
};

/// The rims of all drops of a drive. A rim does not expire, since a robot before a drop soon sees no more of
/// it. It is removed when several sets in a row show floor in its cell, from a place as near as that which
/// the drop was seen from: from farther away the floor beyond a drop is easily taken for floor before it.
/// Allocates only when it holds more rims than ever before.
class RimMemory {
  public:
    /// `cell_m`: edge of a cell of the map.
    explicit RimMemory(double cell_m);

    /// Adds the rims of a set's contact scan. Before that, counts the floor in `evidence`, whose cells are
    /// those of `frame`. Frame and set have the map's frame.
    void note(const ObstacleSet& set, const GridFrame& frame, const std::vector<Evidence>& evidence);

    /// The cells of `rims()`, whose origin is that of the map frame.
    const GridFrame& frame() const { return frame_; }
    const std::vector<Rim>& rims() const { return rims_; }
    /// Middles of the cells that the last call of note() removed, map frame.
    const std::vector<Eigen::Vector2d>& removed_m() const { return removed_m_; }

  private:
    void note_floor(const Eigen::Vector2d& robot_m, const Eigen::Vector2d& floor_m);
    void remove_refuted();
    void add(const Eigen::Vector2d& robot_m, const Eigen::Vector2d& rim_m);

    GridFrame frame_;
    std::vector<Rim> rims_;  ///< ordered by cell
    std::vector<Eigen::Vector2d> removed_m_;
};

}  // namespace flownav::mapping
