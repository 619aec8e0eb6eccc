#pragma once

#include <vector>

#include "flownav/regress/column_file.h"
#include "flownav/report/chart.h"

namespace flownav::regress {

/// Charts of two egomotion.csv over the same times: turn rate, speed, obstacle points, counts and contacts,
/// each with the series A, B and their difference.
std::vector<report::ReportChart> paired_charts(const Columns& before, const Columns& after);

}  // namespace flownav::regress
