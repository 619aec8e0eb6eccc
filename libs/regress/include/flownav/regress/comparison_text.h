#pragma once

#include <string>
#include <vector>

#include "flownav/regress/comparison.h"

namespace flownav::regress {

/// Returns "worse", "better" or an empty text.
const char* to_string(Verdict verdict);

/// Table with one line per change, at most `most`, then the number of further changes.
std::string change_table(const Comparison& comparison, std::size_t most);

/// Differences between the setups of the runs, one line each: programs, settings, rawlogs.
std::vector<std::string> what_differs(const Comparison& comparison);

/// One sentence with the numbers of changed rawlogs.
std::string tally_text(const Tally& tally);

}  // namespace flownav::regress
