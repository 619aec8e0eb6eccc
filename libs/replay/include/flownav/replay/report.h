#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

#include "flownav/replay/drive.h"

namespace flownav {

/// report.html: one file that opens offline, with figures, curves, map and annotated fields. The same drive
/// gives the same bytes.
std::string report_html(const Drive& drive, const mrpt::maps::COccupancyGridMap2D& map);

}  // namespace flownav
