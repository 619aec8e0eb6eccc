#pragma once
#include <string>

#include "flownav/config/config.h"
#include "flownav/evaluation/drive.h"

namespace flownav::evaluation {

/// The text of summary.json: what was read, rejected and written, the errors, the configuration, and in ONE
/// object, "timing", all that may differ from run to run.
std::string summary_json(const Drive& drive, const config::Config& config, const Timing& timing);

}  // namespace flownav::evaluation
