#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <opencv2/core/mat.hpp>
#include <vector>

#include "flownav/evaluation/field_row.h"

namespace flownav::report {

/// The known part of a map, and its place in the frame of the map.
struct MapPicture {
    cv::Mat cells;  ///< 8-bit grey, one pixel a cell, y up: white is free, black occupied, grey unknown
    double left_m = 0.0;
    double bottom_m = 0.0;
    double cell_m = 0.0;
};

/// As much of the map as is known, and the path. The cells are empty when nothing is known. Maps of more than
/// 4000 cells a side come with larger cells.
MapPicture map_picture(const mrpt::maps::COccupancyGridMap2D& grid,
                       const std::vector<evaluation::FieldRow>& rows);

}  // namespace flownav::report
