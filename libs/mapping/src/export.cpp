#include "flownav/mapping/export.h"

#include <mrpt/io/CMemoryStream.h>
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace flownav::mapping {
namespace {

using mrpt::maps::COccupancyGridMap2D;
namespace fs = std::filesystem;

constexpr double occupied_threshold = 0.65;
constexpr double free_threshold = 0.35;
// Grey 205 means an occupancy of 0.1961: a reader must not take the unknown for free.
constexpr double free_threshold_of_file = 0.196;

void write_file(const fs::path& file, const std::string& content) {
    errno = 0;
    std::ofstream out(file, std::ios::binary);
    out << content;
    out.close();
    if (!out) throw std::runtime_error("cannot write '" + file.string() + "': " + std::strerror(errno));
}

bool is_occupied(double p_free) {
    return 1.0 - p_free > occupied_threshold;
}

bool is_free(double p_free) {
    return 1.0 - p_free < free_threshold;
}

/// Grey 0 is occupied, 254 free, 205 unknown; the first row is the largest y.
std::string pgm_of(const COccupancyGridMap2D& grid) {
    constexpr char occupied = 0, free_cell = static_cast<char>(254), unknown = static_cast<char>(205);
    std::ostringstream pgm;
    pgm << "P5\n" << grid.getSizeX() << " " << grid.getSizeY() << "\n255\n";
    for (int y = static_cast<int>(grid.getSizeY()) - 1; y >= 0; --y) {
        for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x) {
            const double p_free = grid.getCell(x, y);
            pgm << (is_occupied(p_free) ? occupied : is_free(p_free) ? free_cell : unknown);
        }
    }
    return pgm.str();
}

std::string yaml_of(const COccupancyGridMap2D& grid) {
    std::ostringstream yaml;
    yaml.imbue(std::locale::classic());
    yaml << "image: map.pgm\nresolution: " << grid.getResolution() << "\norigin: [" << grid.getXMin() << ", "
         << grid.getYMin() << ", 0.0]\nnegate: 0\noccupied_thresh: " << occupied_threshold
         << "\nfree_thresh: " << free_threshold_of_file << "\n";
    return yaml.str();
}

/// The grid as MRPT serializes it, gz-compressed. In memory, because MRPT's own gz file swallows a full disk.
std::string gridmap_of(const COccupancyGridMap2D& grid) {
    mrpt::io::CMemoryStream plain;
    mrpt::serialization::archiveFrom(plain) << grid;
    z_stream z{};
    constexpr int gzip_header = 16;
    constexpr int memory_level = 8;
    if (deflateInit2(&z, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_header + MAX_WBITS, memory_level,
                     Z_DEFAULT_STRATEGY) != Z_OK) {
        throw std::runtime_error("not enough memory to compress the map");
    }
    std::string packed(deflateBound(&z, static_cast<uLong>(plain.getTotalBytesCount())), '\0');
    z.next_in = static_cast<Bytef*>(plain.getRawBufferData());
    z.avail_in = static_cast<uInt>(plain.getTotalBytesCount());
    z.next_out = reinterpret_cast<Bytef*>(packed.data());
    z.avail_out = static_cast<uInt>(packed.size());
    deflate(&z, Z_FINISH);
    packed.resize(z.total_out);
    deflateEnd(&z);
    return packed;
}

}  // namespace

CellCounts count_cells(const COccupancyGridMap2D& grid) {
    CellCounts counts;
    for (int y = 0; y < static_cast<int>(grid.getSizeY()); ++y) {
        for (int x = 0; x < static_cast<int>(grid.getSizeX()); ++x) {
            const double p_free = grid.getCell(x, y);
            counts.occupied += is_occupied(p_free);
            counts.free += is_free(p_free);
        }
    }
    return counts;
}

void export_map(const COccupancyGridMap2D& grid, const fs::path& directory) {
    write_file(directory / "map.pgm", pgm_of(grid));
    write_file(directory / "map.yaml", yaml_of(grid));
    write_file(directory / "map.gridmap.gz", gridmap_of(grid));
}

}  // namespace flownav::mapping
