#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "flownav/core/contact_scan.h"
#include "flownav/core/pose2.h"
#include "flownav/math/footprint.h"
#include "flownav/math/rolling_grid.h"
#include "flownav/nav/guard_params.h"

namespace flownav::nav {

enum class Ground : unsigned char {
    Unknown,
    Unconfirmed,  ///< in view of contact scans that would have confirmed floor, and not confirmed
    Driven,       ///< the robot was there
    Free,         ///< seen to be free
    Occupied
};

/// Memory of the ground around the robot, map frame: cells of the last local maps, what contact scans saw of
/// the floor, and ground that the robot drove over. The newest evidence of a cell holds; unknown cells of a
/// map change nothing, and scans change no cells that the last map shows free. An obstacle that the map no
/// longer shows is forgotten after some scans saw nothing there.
class GroundMemory {
  public:
    explicit GroundMemory(const GroundMemoryParams& params);

    /// A local map (robot frame) and where the robot was. Returns how many cells are free that were unknown.
    int note(const mrpt::maps::COccupancyGridMap2D& local_map, double time_s, const Pose2& T_map_robot);

    /// Takes a contact scan of the record of `time_s`, and where the robot was then. Ground that it confirms
    /// is confirmed for free_s, unless as many scans look there and do not confirm it. Unknown ground in its
    /// view that it does not confirm becomes Unconfirmed when scans like those that looked at it would have
    /// missed floor with less than unconfirmed_chance.
    void note(const ContactScan& scan, double time_s, const Pose2& T_map_robot);

    /// Marks the ground under the robot as driven.
    void mark_traversed(const Polygon& footprint_m, double time_s, const Pose2& T_map_robot);

    Ground at(const Eigen::Vector2d& at_m, double time_s) const;
    /// Driven over, seen to be free, or unknown next to ground that was seen to be free.
    bool is_seen(const Eigen::Vector2d& at_m, double time_s) const;
    /// Unconfirmed, and not a gap of one cell between two free ones.
    bool is_unconfirmed(const Eigen::Vector2d& at_m, double time_s) const;
    /// Not known to be free, but some contact scans looked at it, and none saw anything stand or end there.
    bool is_scanned(const Eigen::Vector2d& at_m, double time_s) const;
    /// Driven over, or confirmed by a contact scan.
    bool is_confirmed(const Eigen::Vector2d& at_m, double time_s) const;
    /// Middles of the occupied cells around a place, map frame.
    std::vector<Eigen::Vector2d> obstacles(const Eigen::Vector2d& around_m, double radius_m,
                                           double time_s) const;
    void forget() { cells_.clear(); }

  private:
    struct Known {
        Ground ground = Ground::Unknown;
        double until_s = 0.0;  ///< time at which the cell is forgotten
        double confirmed_until_s = -std::numeric_limits<double>::infinity();
        int confirmations = 0;  ///< scans that confirmed floor here, less those that did not
        double doubt = 0.0;     ///< -log of the chance that so many scans miss floor here
        int scans = 0;  ///< that looked here and did not confirm floor; since the map showed an obstacle
    };

    Ground at(const Eigen::Vector2i& cell, double time_s) const;
    bool note_cell(const Eigen::Vector2i& cell, bool is_free, double time_s);
    void note_confirmed(const Eigen::Vector2i& cell, double time_s);
    void doubt_confirmed(const Eigen::Vector2i& cell);
    void look_through(const Eigen::Vector2i& cell, double time_s);
    void note_unconfirmed(const Eigen::Vector2i& cell, double doubt, double time_s);
    void note_unknown(const Eigen::Vector2i& cell, const Eigen::Vector2d& at_robot_m, double time_s);

    GroundMemoryParams params_;
    RollingGrid<Known> cells_;   ///< map frame
    double map_s_ = 0.0;         ///< time of the last local map
    double view_begin_m_ = 0.0;  ///< ahead of the robot: nearer, its camera sees no floor
};

}  // namespace flownav::nav
