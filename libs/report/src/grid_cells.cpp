#include "grid_cells.h"

#include <cmath>

namespace flownav::report {

cv::Mat grid_cells(const mrpt::maps::COccupancyGridMap2D& grid, const cv::Rect& part) {
    cv::Mat picture(part.size(), CV_8UC1);
    for (int row = 0; row < part.height; ++row) {
        for (int column = 0; column < part.width; ++column) {
            const float free = grid.getCell(part.x + column, part.y + part.height - 1 - row);
            picture.at<std::uint8_t>(row, column) = static_cast<std::uint8_t>(std::lround(255.0F * free));
        }
    }
    return picture;
}

}  // namespace flownav::report
