#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include "flownav/math/grid2d.h"

namespace flownav::mapping {

/// The cells of a map. Use this instead of MRPT's x2idx() and getPos(), which round toward zero and so take
/// the strip of one cell left of and below the map for its first column and row, and instead of idx2x(),
/// which takes no negative index.
inline GridArea area_of(const mrpt::maps::COccupancyGridMap2D& map) {
    GridArea area;
    area.origin_m = {map.getXMin(), map.getYMin()};
    area.cell_m = map.getResolution();
    area.columns = static_cast<int>(map.getSizeX());
    area.rows = static_cast<int>(map.getSizeY());
    return area;
}

/// Probability of being FREE at a point; 0.5 outside the map.
inline double p_free_at(const mrpt::maps::COccupancyGridMap2D& map, const GridArea& area,
                        const Eigen::Vector2d& p_m) {
    const Eigen::Vector2i cell = area.cell_of(p_m);
    return map.getCell(cell.x(), cell.y());
}

}  // namespace flownav::mapping
