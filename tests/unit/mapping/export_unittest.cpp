#include "flownav/mapping/export.h"

#include <gtest/gtest.h>
#include <mrpt/io/CFileGZInputStream.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <sstream>

#include "../support/temporary_folder.h"
#include "obstacle_sets.h"

namespace flownav::mapping {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using testing::bytes_of;
using testing::occupancy;

/// Something occupied at (1.25, 0.45), free floor at y = -0.65, unknown elsewhere.
COccupancyGridMap2D sample_grid() {
    GlobalMap map({});
    for (int i = 0; i < 6; ++i)
        map.insert({0.0, {}, {testing::point_at(1.25, 0.45)}, {{{0.55, -0.65}, {1.45, -0.65}}}});
    return map.grid();
}

TEST(ExportMap, PgmHasTheGridWithItsLargestYFirst) {
    const testing::TemporaryFolder folder;
    const COccupancyGridMap2D grid = sample_grid();
    export_map(grid, folder / "");
    std::istringstream pgm(bytes_of(folder / "map.pgm"));
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
    const testing::TemporaryFolder folder;
    export_map(sample_grid(), folder / "");
    const std::string bytes = bytes_of(folder / "map.pgm");
    const std::string pixels = bytes.substr(bytes.find("255\n") + 4);
    const CellCounts counts = count_cells(sample_grid());
    EXPECT_EQ(counts.occupied, std::count(pixels.begin(), pixels.end(), '\0'));
    EXPECT_EQ(counts.free, std::count(pixels.begin(), pixels.end(), static_cast<char>(254)));
    EXPECT_GT(counts.occupied, 0U);
    EXPECT_GT(counts.free, 0U);
}

TEST(ExportMap, MrptReadsItBackAsARosMap) {
    const testing::TemporaryFolder folder;
    const COccupancyGridMap2D grid = sample_grid();
    export_map(grid, folder / "");
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
    const testing::TemporaryFolder folder;
    const COccupancyGridMap2D grid = sample_grid();
    export_map(grid, folder / "");
    mrpt::io::CFileGZInputStream in((folder / "map.gridmap.gz").string());
    COccupancyGridMap2D read;
    mrpt::serialization::archiveFrom(in) >> read;
    EXPECT_EQ(read.getRawMap(), grid.getRawMap());
    EXPECT_EQ(read.getXMin(), grid.getXMin());
}

TEST(ExportMap, TheSameGridGivesTheSameBytes) {
    const testing::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "a");
    std::filesystem::create_directories(folder / "b");
    export_map(sample_grid(), folder / "a");
    export_map(sample_grid(), folder / "b");
    for (const std::string name : {"map.pgm", "map.yaml", "map.gridmap.gz"}) {
        EXPECT_FALSE(bytes_of(folder / ("a/" + name)).empty());
        EXPECT_EQ(bytes_of(folder / ("a/" + name)), bytes_of(folder / ("b/" + name))) << name;
    }
}

/// What export_map() complains about.
std::string complaint_about(const std::filesystem::path& directory) {
    try {
        export_map(sample_grid(), directory);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(ExportMap, AFolderThatIsNotThereIsReportedWithTheFile) {
    const testing::TemporaryFolder folder;
    EXPECT_NE(complaint_about(folder / "missing").find((folder / "missing/map.pgm").string()),
              std::string::npos);
}

TEST(ExportMap, EveryFileThatCannotBeWrittenIsNamed) {
    const testing::TemporaryFolder folder;
    for (const std::string name : {"map.gridmap.gz", "map.yaml", "map.pgm"}) {
        const std::filesystem::path directory = folder / ("without_" + name);
        std::filesystem::create_directories(directory / name);  // a folder of that name is in the way
        EXPECT_NE(complaint_about(directory).find((directory / name).string()), std::string::npos) << name;
    }
}

}  // namespace
}  // namespace flownav::mapping
