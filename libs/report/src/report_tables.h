#pragma once
#include <string>

#include "flownav/config/config.h"
#include "flownav/evaluation/drive.h"

namespace flownav::report {

/// The tables of report.html, as HTML: every figure of summary.json but the timing, with its unit and what it
/// means; what was rejected and why.
std::string report_tables(const evaluation::Drive& drive, const config::Config& config);

}  // namespace flownav::report
