#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

#include "flownav/replay/drive.h"
#include "flownav/sensor/config.h"

namespace flownav {

/// report.html: one file that opens offline, with linked charts over time, way, map, annotated fields and
/// every figure in words. The same drive gives the same bytes. `timing`: the object of that name of
/// summary.json when it shall be shown, else empty.
std::string report_html(const Drive& drive, const mrpt::maps::COccupancyGridMap2D& map, const Config& config,
                        const std::string& timing = "");

}  // namespace flownav
