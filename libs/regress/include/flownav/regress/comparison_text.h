#pragma once

#include <string>
#include <vector>

#include "flownav/regress/comparison.h"

namespace flownav::regress {

/// "worse", "better", or nothing.
const char* to_string(Verdict verdict);

/// A line a change, in columns; at most `most`, then how many there are more.
std::string change_table(const Comparison& comparison, std::size_t most);

/// What differs between the runs themselves, a line each: programs, settings, rawlogs.
std::vector<std::string> what_differs(const Comparison& comparison);

/// How many rawlogs changed, in a sentence.
std::string tally_text(const Tally& tally);

}  // namespace flownav::regress
