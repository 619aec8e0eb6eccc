#pragma once

#include <string>

#include "flownav/regress/comparison.h"

namespace flownav::regress {

/// Two runs, as a page shows them.
struct NamedRuns {
    std::string name_before, name_after;  ///< their folders
    RunResults before, after;
};

/// A page that opens offline: what changed at a glance, every change, and the ways, maps and curves of both
/// runs. It holds those of the rawlogs that changed most only, lest it become too large.
std::string compare_html(const Comparison& comparison, const NamedRuns& runs);

}  // namespace flownav::regress
