#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>

#include "flownav/drive/simulated_drive.h"

namespace flownav {

/// What a drive looks like from above: the map as the robot drew it (white free, black occupied, grey
/// unknown), the believed way (orange), start and goal; in a simulation the true way (blue) and the true
/// outlines of everything that can be hit, and where it touched something. 8-bit BGR, x to the right, y up.
cv::Mat drive_picture(const drive::SimulatedDriveOptions& options, const drive::DriveResult& result,
                      const mrpt::maps::COccupancyGridMap2D& map);

}  // namespace flownav
