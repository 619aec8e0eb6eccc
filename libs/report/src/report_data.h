#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

#include "flownav/evaluation/drive.h"
#include "flownav/report/filmstrip.h"

namespace flownav {

/// Everything that the script of report.html draws, as JSON that may stand inside a <script> element whatever
/// names it holds. `timing` may be null.
std::string report_data(const Drive& drive, const Filmstrip& filmstrip,
                        const mrpt::maps::COccupancyGridMap2D& map, const Timing* timing);

}  // namespace flownav
