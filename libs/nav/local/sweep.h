#pragma once

#include <functional>
#include <vector>

#include "flownav/nav/footprint_field.h"
#include "flownav/nav/lane_tables.h"

namespace flownav::nav {

/// Where the robot is after `way` of a lane (metres, or radians when it turns on the spot).
using PoseOfWay = std::function<Pose2(double way)>;

/// How a sweep is sampled and what counts as touching.
struct SweepParams {
    double end = 0.0;       ///< of the way
    double step = 0.025;    ///< of the way
    double margin_m = 0.0;  ///< nearer than this to the middle of a cell is touching it
    double unit = 0.001;    ///< of LaneCell::way
};

/// Cells that a footprint meets or passes within the field's reach, ordered by LaneCell::way.
///
/// A cell that the robot stands on or beside at the beginning only counts as touched once the robot comes
/// nearer to it: it must be able to leave.
std::vector<LaneCell> sweep(const FootprintField& field, const GridArea& grid, const PoseOfWay& pose_of,
                            const SweepParams& params);

}  // namespace flownav::nav
