#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <opencv2/core/mat.hpp>
#include <vector>

#include "flownav/replay/field_row.h"

namespace flownav {

/// A picture for people (8-bit BGR) of the known part of a map, x to the right and y up, with the path
/// driven, its start, its end and a scale bar. White is free, black is occupied, grey unknown. Empty when
/// nothing is known.
cv::Mat map_picture(const mrpt::maps::COccupancyGridMap2D& grid, const std::vector<FieldRow>& rows);

}  // namespace flownav
