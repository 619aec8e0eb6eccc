#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>

#include "simulated_drive.h"

namespace flownav {

/// What a drive looks like from above: the map as the robot drew it (white free, black occupied, grey
/// unknown), the true outlines of everything that can be hit, the true way (blue) and the believed one
/// (orange), start, goal, and where it touched something. 8-bit BGR, x to the right and y up.
cv::Mat drive_picture(const SimulatedDriveOptions& options, const DriveResult& result,
                      const mrpt::maps::COccupancyGridMap2D& map);

}  // namespace flownav
