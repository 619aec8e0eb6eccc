#include "flownav/mapping/export.h"

#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace flownav {
namespace {

using mrpt::maps::COccupancyGridMap2D;
namespace fs = std::filesystem;

constexpr double occupied_threshold = 0.65;
constexpr double free_threshold = 0.35;

void write_file(const fs::path& file, const std::string& content) {
    std::ofstream out(file, std::ios::binary);
    out << content;
    out.close();
    if (!out) throw std::runtime_error("cannot write '" + file.string() + "': disk full or no permission");
}

/// Grey 0 is occupied, 254 free, 205 unknown; the first row is the largest y.
std::string pgm_of(const COccupancyGridMap2D& grid) {
    constexpr char occupied = 0, free_cell = static_cast<char>(254), unknown = static_cast<char>(205);
    std::ostringstream pgm;
    pgm << "P5\n" << grid.getSizeX() << " " << grid.getSizeY() << "\n255\n";
    for (int y = static_cast<int>(grid.getSizeY()) - 1; y >= 0; --y) {
        for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x) {
            const double occupancy = 1.0 - grid.getCell(x, y);
            pgm << (occupancy > occupied_threshold ? occupied
                    : occupancy < free_threshold   ? free_cell
                                                   : unknown);
        }
    }
    return pgm.str();
}

std::string yaml_of(const COccupancyGridMap2D& grid) {
    std::ostringstream yaml;
    yaml.imbue(std::locale::classic());
    yaml << "image: map.pgm\nresolution: " << grid.getResolution() << "\norigin: [" << grid.getXMin() << ", "
         << grid.getYMin() << ", 0.0]\nnegate: 0\noccupied_thresh: " << occupied_threshold
         << "\nfree_thresh: " << free_threshold << "\n";
    return yaml.str();
}

}  // namespace

void export_map(const COccupancyGridMap2D& grid, const fs::path& directory) {
    write_file(directory / "map.pgm", pgm_of(grid));
    write_file(directory / "map.yaml", yaml_of(grid));
    const fs::path gridmap = directory / "map.gridmap.gz";
    try {
        mrpt::io::CFileGZOutputStream out;
        if (!out.open(gridmap.string())) throw std::runtime_error("cannot open");
        auto archive = mrpt::serialization::archiveFrom(out);
        archive << grid;
    } catch (const std::exception& e) {
        throw std::runtime_error("cannot write '" + gridmap.string() + "': disk full or no permission");
    }
}

}  // namespace flownav
