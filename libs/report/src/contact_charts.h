#pragma once
#include <vector>

#include "flownav/evaluation/drive.h"
#include "flownav/report/chart.h"

namespace flownav::report {

/// Rows of a drive that a chart shows.
using ChartRows = std::vector<const evaluation::FieldRow*>;

/// An empty chart with a time for each row that `is_shown` accepts, and for the first and the last row, which
/// go to `shown`.
ReportChart chart_of_rows(const evaluation::Drive& drive, ChartRows& shown,
                          bool (*is_shown)(const evaluation::FieldRow&));

/// Strips of the contact scans over time, and the fit of the floor; empty for a drive without a scan.
std::vector<ReportChart> contact_charts(const evaluation::Drive& drive);

}  // namespace flownav::report
