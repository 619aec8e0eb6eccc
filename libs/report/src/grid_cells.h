#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <opencv2/core/mat.hpp>

namespace flownav::report {

/// Part of a grid (in cells, from its lower left) as an 8-bit picture, one pixel a cell, y up: 0 is occupied,
/// 255 free. Outside the grid MRPT returns 0.5, unknown.
cv::Mat grid_cells(const mrpt::maps::COccupancyGridMap2D& grid, const cv::Rect& part);

}  // namespace flownav::report
