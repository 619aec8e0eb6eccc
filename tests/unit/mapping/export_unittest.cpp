#include "flownav/mapping/export.h"

#include <gtest/gtest.h>
#include <mrpt/serialization/CSerializable.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "../support/temporary_folder.h"
#include "obstacle_sets.h"

namespace flownav::mapping {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using testing::occupancy;

/// A map with an occupied cell at (1.25, 0.45), free floor at y = -0.65, unknown elsewhere.
COccupancyGridMap2D sample_grid() {
    GlobalMap map({});
    for (int i = 0; i < 6; ++i)
        map.insert({0.0, {}, {testing::point_at(1.25, 0.45)}, {{{0.55, -0.65}, {1.45, -0.65}}}});
    return map.grid();
}

TEST(ExportMap, PgmHasTheGridWithItsLargestYFirst) {
    const COccupancyGridMap2D grid = sample_grid();
    std::istringstream pgm(export_map(grid).pgm);
    std::string magic;
    int width = 0, height = 0, maximum = 0;
    pgm >> magic >> width >> height >> maximum;
    pgm.get();
    std::string pixels(std::istreambuf_iterator<char>(pgm), {});
    EXPECT_EQ(magic, "P5");
    EXPECT_EQ(width, static_cast<int>(grid.getSizeX()));
    EXPECT_EQ(height, static_cast<int>(grid.getSizeY()));
    EXPECT_EQ(maximum, 255);
    ASSERT_EQ(pixels.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto grey = [&](float x_m, float y_m) {
        const std::ptrdiff_t row = height - 1 - grid.y2idx(y_m);
        return static_cast<unsigned char>(*(pixels.begin() + row * width + grid.x2idx(x_m)));
    };
    EXPECT_EQ(grey(1.25F, 0.45F), 0);
    EXPECT_EQ(grey(1.05F, -0.65F), 254);
    EXPECT_EQ(grey(-1.0F, 1.0F), 205);
}

TEST(ExportMap, TheCellsAreCountedAsThePictureShowsThem) {
    const std::string bytes = export_map(sample_grid()).pgm;
    const std::string pixels = bytes.substr(bytes.find("255\n") + 4);
    const CellCounts counts = count_cells(sample_grid());
    EXPECT_EQ(counts.occupied, std::count(pixels.begin(), pixels.end(), '\0'));
    EXPECT_EQ(counts.free, std::count(pixels.begin(), pixels.end(), static_cast<char>(254)));
    EXPECT_GT(counts.occupied, 0U);
    EXPECT_GT(counts.free, 0U);
}

/// The limits lie beyond every cell of the map: all cells are unknown, in the picture and in the counts.
TEST(ExportMap, TheLimitsDecideWhichCellsAreOccupiedAndFree) {
    OccupancyLimits limits;
    limits.export_occupied_below = 0.01;
    limits.export_free_above = 0.99;
    const MapFiles files = export_map(sample_grid(), limits);
    const std::string pixels = files.pgm.substr(files.pgm.find("255\n") + 4);
    EXPECT_EQ(pixels.find_first_not_of(static_cast<char>(205)), std::string::npos);
    EXPECT_EQ(count_cells(sample_grid(), limits).occupied, 0U);
    EXPECT_EQ(count_cells(sample_grid(), limits).free, 0U);
    EXPECT_NE(files.yaml.find("occupied_thresh: 0.99\n"), std::string::npos);
}

TEST(ExportMap, MrptReadsItBackAsARosMap) {
    const testing::TemporaryFolder folder;
    const COccupancyGridMap2D grid = sample_grid();
    const MapFiles files = export_map(grid);
    std::ofstream(folder / "map.pgm", std::ios::binary) << files.pgm;
    std::ofstream(folder / "map.yaml") << files.yaml;
    COccupancyGridMap2D read;
    ASSERT_TRUE(read.loadFromROSMapServerYAML((folder / "map.yaml").string()));
    EXPECT_EQ(read.getSizeX(), grid.getSizeX());
    EXPECT_EQ(read.getSizeY(), grid.getSizeY());
    EXPECT_NEAR(read.getResolution(), grid.getResolution(), 1e-6);
    EXPECT_NEAR(read.getXMin(), grid.getXMin(), 1e-4);
    EXPECT_NEAR(read.getYMin(), grid.getYMin(), 1e-4);
    EXPECT_EQ(testing::occupied_cells(read), testing::occupied_cells(grid));
    EXPECT_GT(occupancy(read, 1.25, 0.45), 0.65);
    EXPECT_LT(occupancy(read, 1.05, -0.65), 0.35);
    EXPECT_NEAR(occupancy(read, -1.0, 1.0), 0.5, 0.01);  // never seen: unknown, not free
}

TEST(ExportMap, GridmapIsTheGridItself) {
    const COccupancyGridMap2D grid = sample_grid();
    mrpt::serialization::CSerializable::Ptr object;
    mrpt::serialization::OctetVectorToObject(export_map(grid).gridmap, object);
    const auto read = std::dynamic_pointer_cast<COccupancyGridMap2D>(object);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->getRawMap(), grid.getRawMap());
    EXPECT_EQ(read->getXMin(), grid.getXMin());
}

TEST(ExportMap, TheSameGridGivesTheSameBytes) {
    const MapFiles one = export_map(sample_grid());
    const MapFiles other = export_map(sample_grid());
    EXPECT_FALSE(one.pgm.empty() || one.yaml.empty() || one.gridmap.empty());
    EXPECT_EQ(one.pgm, other.pgm);
    EXPECT_EQ(one.yaml, other.yaml);
    EXPECT_EQ(one.gridmap, other.gridmap);
}

}  // namespace
}  // namespace flownav::mapping
