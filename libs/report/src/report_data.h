#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

#include "flownav/evaluation/drive.h"
#include "flownav/report/thumbnail_strip.h"

namespace flownav::report {

/// Everything that the script of report.html draws, as JSON that may stand inside a <script> element whatever
/// names it holds. `timing` may be null.
std::string report_data(const evaluation::Drive& drive, const ThumbnailStrip& thumbnail_strip,
                        const mrpt::maps::COccupancyGridMap2D& map, const evaluation::Timing* timing);

}  // namespace flownav::report
