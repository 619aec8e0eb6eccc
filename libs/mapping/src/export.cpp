#include "flownav/mapping/export.h"

#include <mrpt/serialization/CSerializable.h>

#include <sstream>

namespace flownav::mapping {
namespace {

using mrpt::maps::COccupancyGridMap2D;

// Below the occupancy of grey 205 (0.1961), so that a reader does not take unknown cells for free.
constexpr double free_threshold_of_file = 0.196;

bool is_occupied(double p_free, const OccupancyLimits& limits) {
    return p_free < limits.export_occupied_below;
}

bool is_free(double p_free, const OccupancyLimits& limits) {
    return p_free > limits.export_free_above;
}

std::string pgm_of(const COccupancyGridMap2D& grid, const OccupancyLimits& limits) {
    std::ostringstream pgm;
    pgm << "P5\n" << grid.getSizeX() << " " << grid.getSizeY() << "\n255\n";
    for (int y = static_cast<int>(grid.getSizeY()) - 1; y >= 0; --y) {
        for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x) {
            const double p_free = grid.getCell(x, y);
            pgm << (static_cast<char>(is_occupied(p_free, limits) ? MapFiles::occupied
                                      : is_free(p_free, limits)   ? MapFiles::free
                                                                  : MapFiles::unknown));
        }
    }
    return pgm.str();
}

std::string yaml_of(const COccupancyGridMap2D& grid, const OccupancyLimits& limits) {
    std::ostringstream yaml;
    yaml.imbue(std::locale::classic());
    yaml << "image: map.pgm\nresolution: " << grid.getResolution() << "\norigin: [" << grid.getXMin() << ", "
         << grid.getYMin() << ", 0.0]\nnegate: 0\noccupied_thresh: " << 1.0 - limits.export_occupied_below
         << "\nfree_thresh: " << free_threshold_of_file << "\n";
    return yaml.str();
}

std::vector<std::uint8_t> gridmap_of(const COccupancyGridMap2D& grid) {
    std::vector<std::uint8_t> bytes;
    mrpt::serialization::ObjectToOctetVector(&grid, bytes);
    return bytes;
}

}  // namespace

CellCounts count_cells(const COccupancyGridMap2D& grid, const OccupancyLimits& limits) {
    CellCounts counts;
    for (int y = 0; y < static_cast<int>(grid.getSizeY()); ++y) {
        for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x) {
            const double p_free = grid.getCell(x, y);
            counts.occupied += is_occupied(p_free, limits);
            counts.free += is_free(p_free, limits);
        }
    }
    return counts;
}

MapFiles export_map(const COccupancyGridMap2D& grid, const OccupancyLimits& limits) {
    return {pgm_of(grid, limits), yaml_of(grid, limits), gridmap_of(grid)};
}

}  // namespace flownav::mapping
