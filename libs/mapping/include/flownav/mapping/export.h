#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <cstdint>
#include <filesystem>

namespace flownav::mapping {

/// Cells of a map as map.pgm shows them.
struct CellCounts {
    std::uint64_t occupied = 0;
    std::uint64_t free = 0;
};

CellCounts count_cells(const mrpt::maps::COccupancyGridMap2D& grid);

/// Writes map.pgm + map.yaml (ROS map_server, trinary) and map.gridmap.gz (MRPT's tools) into `directory`.
/// Throws std::runtime_error naming the file that could not be written. Same grid, same bytes.
void export_map(const mrpt::maps::COccupancyGridMap2D& grid, const std::filesystem::path& directory);

}  // namespace flownav::mapping
