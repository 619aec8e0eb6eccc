#pragma once
#include <nlohmann/json.hpp>

#include "flownav/config/config.h"
#include "flownav/evaluation/drive.h"

namespace flownav::evaluation {

/// Content of summary.json without the object "timing".
nlohmann::ordered_json summary_facts(const Drive& drive, const config::Config& config);

/// The object "timing" of summary.json.
nlohmann::ordered_json timing_facts(const Timing& timing);

}  // namespace flownav::evaluation
