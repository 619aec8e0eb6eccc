#include "flownav/regress/paired_maps.h"

#include <mrpt/containers/yaml.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "flownav/io/picture_file.h"
#include "flownav/mapping/export.h"

namespace flownav::regress {

namespace {

using mapping::MapFiles;

constexpr std::uint8_t occupied = MapFiles::occupied;
constexpr std::uint8_t unknown = MapFiles::unknown;
constexpr int margin_cells = 3;
constexpr double most_cells = 1200.0;

/// A rectangle in metres.
struct Extent {
    double left = HUGE_VAL, bottom = HUGE_VAL, right = -HUGE_VAL, top = -HUGE_VAL;
    bool empty() const { return left >= right; }
};

/// Extends `extent` to the known cells of the map.
void extend(Extent& extent, const MapFile& map) {
    for (int row = 0; row < map.cells.rows; ++row) {
        for (int column = 0; column < map.cells.cols; ++column) {
            if (map.cells.at<std::uint8_t>(row, column) == unknown) continue;
            const double x = map.left_m + column * map.cell_m;
            const double y = map.bottom_m + (map.cells.rows - 1 - row) * map.cell_m;
            extent.left = std::min(extent.left, x);
            extent.bottom = std::min(extent.bottom, y);
            extent.right = std::max(extent.right, x + map.cell_m);
            extent.top = std::max(extent.top, y + map.cell_m);
        }
    }
}

int rank(std::uint8_t cell) {
    return cell == occupied ? 2 : cell == unknown ? 0 : 1;
}

/// Draws all cells of a map into another raster.
class Painter {
  public:
    Painter(cv::Mat& picture, const PairedMaps& raster) : picture_(picture), raster_(raster) {}

    void paint(const MapFile& map) {
        for (int row = 0; row < map.cells.rows; ++row) {
            for (int column = 0; column < map.cells.cols; ++column)
                paint_cell(map, row, column, map.cells.at<std::uint8_t>(row, column));
        }
    }

  private:
    struct Span {
        int from, to;
    };

    Span span(double from_m, double length_m, double start_m, int count) const {
        constexpr double rounding = 1e-6;
        const double from = (from_m - start_m) / raster_.cell_m;
        const double to = from + length_m / raster_.cell_m;
        return {std::max(0, static_cast<int>(std::floor(from + rounding))),
                std::min(count, static_cast<int>(std::ceil(to - rounding)))};
    }

    void paint_cell(const MapFile& map, int row, int column, std::uint8_t value) {
        if (value == unknown) return;
        const Span x = span(map.left_m + column * map.cell_m, map.cell_m, raster_.left_m, picture_.cols);
        const Span y = span(map.bottom_m + (map.cells.rows - 1 - row) * map.cell_m, map.cell_m,
                            raster_.bottom_m, picture_.rows);
        for (int i = y.from; i < y.to; ++i) {
            for (int k = x.from; k < x.to; ++k) {
                auto& cell = picture_.at<std::uint8_t>(picture_.rows - 1 - i, k);
                if (rank(value) > rank(cell)) cell = value;
            }
        }
    }

    cv::Mat& picture_;
    const PairedMaps& raster_;
};

}  // namespace

std::optional<MapFile> read_map(const std::filesystem::path& folder) try {
    if (!std::filesystem::exists(folder / "map.yaml")) return std::nullopt;
    const auto yaml = mrpt::containers::yaml::FromFile(folder / "map.yaml");
    MapFile map;
    map.cells = io::read_picture(folder / "map.pgm", cv::IMREAD_GRAYSCALE);
    map.cell_m = yaml["resolution"].as<double>();
    map.left_m = yaml["origin"](0).as<double>();
    map.bottom_m = yaml["origin"](1).as<double>();
    if (map.cells.empty() || !(map.cell_m > 0.0)) return std::nullopt;
    return map;
} catch (const std::exception&) {  // thrown by MRPT for an unreadable text
    return std::nullopt;
}

std::optional<PairedMaps> paired(const MapFile& before, const MapFile& after) {
    Extent extent;
    extend(extent, before);
    extend(extent, after);
    if (extent.empty()) return std::nullopt;
    const double side_m = std::max(extent.right - extent.left, extent.top - extent.bottom);
    const double finest_m = std::min(before.cell_m, after.cell_m);
    PairedMaps maps;
    maps.cell_m = finest_m * std::ceil(side_m / finest_m / most_cells);
    maps.left_m = extent.left - margin_cells * maps.cell_m;
    maps.bottom_m = extent.bottom - margin_cells * maps.cell_m;
    const auto cells = [&](double length_m) {
        return static_cast<int>(std::lround(std::ceil(length_m / maps.cell_m - 1e-6))) + 2 * margin_cells;
    };
    const cv::Size size(cells(extent.right - extent.left), cells(extent.top - extent.bottom));
    for (const auto& [picture, map] : {std::pair(&maps.before, &before), std::pair(&maps.after, &after)}) {
        *picture = cv::Mat(size, CV_8UC1, cv::Scalar(unknown));
        Painter(*picture, maps).paint(*map);
    }
    maps.only_before = cv::countNonZero((maps.before == occupied) & (maps.after != occupied));
    maps.only_after = cv::countNonZero((maps.after == occupied) & (maps.before != occupied));
    maps.both = cv::countNonZero((maps.before == occupied) & (maps.after == occupied));
    return maps;
}

cv::Mat difference_picture(const PairedMaps& maps, const DifferenceColours& colours) {
    cv::Mat picture(maps.before.size(), CV_8UC3, cv::Scalar(colours.unknown));
    picture.setTo(colours.free, (maps.before != unknown) | (maps.after != unknown));
    picture.setTo(colours.only_before, maps.before == occupied);
    picture.setTo(colours.only_after, maps.after == occupied);
    picture.setTo(colours.both, (maps.before == occupied) & (maps.after == occupied));
    return picture;
}

}  // namespace flownav::regress
