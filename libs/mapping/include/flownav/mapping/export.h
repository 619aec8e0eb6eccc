#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cstdint>
#include <string>
#include <vector>

#include "flownav/mapping/occupancy_limits.h"

namespace flownav::mapping {

/// Numbers of occupied and free cells, by the thresholds of map.pgm.
struct CellCounts {
    std::uint64_t occupied = 0;
    std::uint64_t free = 0;
};

CellCounts count_cells(const mrpt::maps::COccupancyGridMap2D& grid, const OccupancyLimits& limits = {});

/// A map as files: map.pgm and map.yaml for ROS map_server (trinary), and MRPT's grid.
struct MapFiles {
    // The greys of map.pgm, whose first row has the largest y.
    static constexpr std::uint8_t occupied = 0;
    static constexpr std::uint8_t free = 254;
    static constexpr std::uint8_t unknown = 205;

    std::string pgm;
    std::string yaml;
    std::vector<std::uint8_t> gridmap;  ///< for map.gridmap.gz, not yet compressed
};

/// The same grid gives the same bytes.
MapFiles export_map(const mrpt::maps::COccupancyGridMap2D& grid, const OccupancyLimits& limits = {});

}  // namespace flownav::mapping
