#pragma once

#include <nlohmann/json_fwd.hpp>

#include "flownav/regress/run_results.h"

namespace flownav::regress {

/// Ways, maps and curves of one rawlog in two runs, for the page; null where a run kept only its figures.
nlohmann::ordered_json drive_pair(const RawlogResult& before, const RawlogResult& after);

}  // namespace flownav::regress
