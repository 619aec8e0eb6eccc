#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/math/footprint.h"
#include "flownav/math/grid2d.h"

namespace flownav::nav {

enum class Ground : unsigned char {
    Unknown,
    Driven,  ///< the robot was there
    Free,    ///< seen to be free
    Occupied
};

struct GroundMemoryParams {
    double cell_m = 0.05;
    double reach_m = 4.0;         ///< of the memory around the robot
    double p_occupied = 0.4;      ///< cells of the map less likely FREE than this are obstacles
    double p_free = 0.55;         ///< and more likely than this, seen to be free
    double obstacle_s = 60.0;     ///< an obstacle that the map no longer shows is remembered for so long,
    double in_view_s = 10.0;      ///< or, when the camera looks there and finds nothing any more, for so long
    double view_half_rad = 0.35;  ///< the camera looks so far to either side
    double free_s = 30.0;         ///< and free ground
    double driven_s = 120.0;      ///< and ground that the robot drove over
    double seen_near_m = 0.08;    ///< ground counts as seen when a cell this near was
};

/// What is known of the ground around the robot, in the map frame: what the last local maps showed, and where
/// the robot itself has been. The newest word on a cell holds; a map that says nothing changes nothing.
class GroundMemory {
  public:
    explicit GroundMemory(const GroundMemoryParams& params);

    /// A local map (robot frame) and where the robot was. Returns how many cells are free that were unknown.
    int note(const mrpt::maps::COccupancyGridMap2D& local_map, double time_s, const Pose2& T_map_robot);

    /// The robot stands here: nothing else does.
    void mark_traversed(const Polygon& footprint_m, double time_s, const Pose2& T_map_robot);

    Ground at(const Eigen::Vector2d& at_m, double time_s) const;
    /// Driven over, seen to be free, or unknown next to ground that was seen to be free.
    bool is_seen(const Eigen::Vector2d& at_m, double time_s) const;
    /// Middles of the occupied cells around a place, map frame.
    std::vector<Eigen::Vector2d> obstacles(const Eigen::Vector2d& around_m, double radius_m,
                                           double time_s) const;
    void forget() { cells_.assign(cells_.size(), Cell{}); }

  private:
    struct Cell {
        Eigen::Vector2i index = Eigen::Vector2i::Zero();
        Ground ground = Ground::Unknown;
        double until_s = 0.0;
    };

    Cell& place(const Eigen::Vector2i& index);
    const Cell& place(const Eigen::Vector2i& index) const;
    Ground at(const Eigen::Vector2i& index, double time_s) const;
    bool note_cell(const Eigen::Vector2i& index, bool is_free, double time_s);
    void note_silence(const Eigen::Vector2i& index, const Eigen::Vector2d& at_robot_m, double time_s);

    GroundMemoryParams params_;
    GridFrame frame_;  ///< of the map frame
    int side_;         ///< cells along the edge of the ring
    std::vector<Cell> cells_;
};

}  // namespace flownav::nav
