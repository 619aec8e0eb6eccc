#include "flownav/report/map_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/mapping/grid_area.h"
#include "grid_cells.h"

namespace flownav::report {

namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

constexpr float unknown_band = 0.02F;
constexpr int margin_cells = 5;
constexpr int most_cells = 4000;

cv::Rect known_part(const Grid& grid) {
    cv::Rect known;
    const int columns = static_cast<int>(grid.getSizeX());
    const int rows = static_cast<int>(grid.getSizeY());
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            if (std::abs(grid.getCell(x, y) - 0.5F) > unknown_band) known |= cv::Rect(x, y, 1, 1);
        }
    }
    return known;
}

cv::Rect path_part(const Grid& grid, const std::vector<evaluation::FieldRow>& rows) {
    const GridArea area = mapping::area_of(grid);
    cv::Rect part;
    for (const evaluation::FieldRow& row : rows) {
        const Pose2& pose = row.T_start_robot;
        const Eigen::Vector2i cell = area.cell_of({pose.x_m, pose.y_m});
        part |= cv::Rect(cell.x(), cell.y(), 1, 1);
    }
    return part;
}

}  // namespace

MapPicture map_picture(const Grid& grid, const std::vector<evaluation::FieldRow>& rows) {
    MapPicture picture;
    cv::Rect part = known_part(grid);
    if (part.empty()) return picture;
    part |= path_part(grid, rows);
    const int together = std::max(part.width, part.height) / most_cells + 1;
    const auto whole = [&](int length) { return (length / together + 1) * together; };
    part = cv::Rect(part.x - margin_cells, part.y - margin_cells, whole(part.width + 2 * margin_cells),
                    whole(part.height + 2 * margin_cells));
    picture.cells = grid_cells(grid, part);
    picture.cell_m = together * static_cast<double>(grid.getResolution());
    picture.left_m = grid.getXMin() + part.x * static_cast<double>(grid.getResolution());
    picture.bottom_m = grid.getYMin() + part.y * static_cast<double>(grid.getResolution());
    if (together > 1) cv::resize(picture.cells, picture.cells, part.size() / together, 0, 0, cv::INTER_AREA);
    return picture;
}

}  // namespace flownav::report
