#pragma once
#include <nlohmann/json.hpp>

#include "flownav/replay/drive.h"
#include "flownav/sensor/config.h"

namespace flownav {

/// summary.json without its timing.
nlohmann::ordered_json summary_facts(const Drive& drive, const Config& config);

/// The object "timing" of summary.json.
nlohmann::ordered_json timing_facts(const Timing& timing);

}  // namespace flownav
