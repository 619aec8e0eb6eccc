#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "flownav/core/robot_model.h"
#include "flownav/math/grid2d.h"
#include "flownav/nav/footprint_field.h"

namespace flownav::nav {

/// The set of lanes, and the distance from their sides at which obstacles are noticed.
struct LaneLayout {
    double map_size_m = 10.0;      ///< edge of the local map, robot in the middle
    double resolution_m = 0.1;     ///< edge of a cell
    int lanes = 41;                ///< from hard right to hard left; odd: the middle one is straight
    double radius_min_m = 0.3;     ///< radius of the hardest turn
    double length_m = 4.0;         ///< length of a lane
    double margin_m = 0.05;        ///< from the footprint to the MIDDLE of a cell: nearer counts as touching
    double tight_margin_m = 0.03;  ///< margin for turning on the spot, and for lanes when no other is open
    double side_m = 0.35;          ///< obstacles this near to the footprint count as beside the lane
    int headings = 48;             ///< number of straight lanes after turning on the spot
};

/// One cell in or beside a lane.
struct LaneCell {
    std::uint32_t index = 0;
    /// Distance in mm (turning: angle in mrad) at which the robot touches it, or is nearest to it.
    std::uint16_t way = 0;
    std::uint8_t gap = 0;  ///< distance to the footprint in units of 5 mm, 0: touched
};
constexpr double gap_unit_m = 0.005;

/// An arc, or a straight line after turning by heading_rad on the spot.
struct Lane {
    double curvature_1pm = 0.0;  ///< omega / v, > 0 to the left
    double heading_rad = 0.0;
    double length_m = 0.0;
    std::vector<LaneCell> cells;  ///< ordered by way
};

/// Lane data that does not depend on the map.
struct LaneTables {
    LaneLayout layout;
    RobotModel robot;
    FootprintField field;
    GridArea grid;                                ///< of the local map, robot frame
    std::vector<Lane> lanes;                      ///< ordered by curvature, from right to left
    std::vector<Lane> tight_lanes;                ///< `lanes` with the tight margin
    std::vector<Lane> headings;                   ///< ordered by heading, from -pi
    std::vector<LaneCell> turn_left, turn_right;  ///< half a turn on the spot
};

/// Takes about 0.1 s. Throws std::invalid_argument for an inconsistent layout.
LaneTables make_lane_tables(const RobotModel& robot, const LaneLayout& layout);

}  // namespace flownav::nav
