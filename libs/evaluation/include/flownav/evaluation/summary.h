#pragma once
#include <string>

#include "flownav/config/config.h"
#include "flownav/evaluation/drive.h"

namespace flownav::evaluation {

/// Text of summary.json: counts of observations read, rejected and written, errors, configuration, and the
/// object "timing". Only "timing" may differ between runs.
std::string summary_json(const Drive& drive, const config::Config& config, const Timing& timing);

}  // namespace flownav::evaluation
