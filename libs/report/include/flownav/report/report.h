#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

#include "flownav/config/config.h"
#include "flownav/evaluation/drive.h"
#include "flownav/report/thumbnail_strip.h"

namespace flownav::report {

/// report.html: one file that opens offline, with linked charts over time, way, map, annotated fields and
/// every figure in words. The same drive gives the same bytes, unless the times of `timing` shall be shown.
std::string report_html(const evaluation::Drive& drive, const ThumbnailStrip& thumbnail_strip,
                        const mrpt::maps::COccupancyGridMap2D& map, const config::Config& config,
                        const evaluation::Timing* timing = nullptr);

}  // namespace flownav::report
