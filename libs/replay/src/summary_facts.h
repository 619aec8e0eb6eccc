#pragma once
#include <nlohmann/json.hpp>

#include "flownav/replay/drive.h"
#include "flownav/sensor/config.h"

namespace flownav {

/// summary.json without its timing.
nlohmann::ordered_json summary_facts(const Drive& drive, const Config& config);

/// The object "timing" of summary.json, as text.
std::string timing_json(const Timing& timing, std::size_t fields);

}  // namespace flownav
