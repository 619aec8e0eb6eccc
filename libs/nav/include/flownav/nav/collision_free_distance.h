#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cstdint>
#include <vector>

#include "flownav/core/robot_model.h"
#include "flownav/mapping/occupancy_limits.h"
#include "flownav/nav/footprint_field.h"

namespace flownav::nav {

/// What a cell of a map means to a robot that wants to drive over it.
enum class CellKind : std::uint8_t { Free, Unknown, Weak, Occupied };

/// Kind of every cell, row by row as in the map.
std::vector<CellKind> kinds_of(const mrpt::maps::COccupancyGridMap2D& map,
                               const mapping::OccupancyLimits& limits);

struct CollisionFreeParams {
    mapping::OccupancyLimits limits;
    double length_m = 4.0;         ///< how far to look
    double margin_m = 0.03;        ///< nearer than this to the middle of a cell is touching it
    double bumper_m = 0.4;         ///< unknown ground within this way does not count: no camera sees it
    double unseen_area_m2 = 0.02;  ///< smaller patches of unknown ground do not count
};

/// How far a command leads over a map: metres, when turning on the spot radians.
struct CollisionFreeDistance {
    double occupied = 0.0;  ///< to the first touch of an obstacle
    double unseen = 0.0;    ///< to the first ground that nobody has seen, at most `occupied`
};

/// Free way of a robot along a steady command, forward, backward or turning on the spot (then up to half a
/// turn). The map is in the robot's frame; what lies outside is unknown. What the robot stands beside at the
/// beginning only counts once it comes nearer to it.
CollisionFreeDistance collision_free_distance(const FootprintField& field,
                                              const mrpt::maps::COccupancyGridMap2D& map,
                                              const MotionCommand& command,
                                              const CollisionFreeParams& params);

}  // namespace flownav::nav
