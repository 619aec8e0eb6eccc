#pragma once

#include <string>

#include "flownav/regress/comparison.h"

namespace flownav::regress {

/// Two runs with their names.
struct NamedRuns {
    std::string name_before, name_after;  ///< names of their folders
    RunResults before, after;
};

/// Builds a page that opens offline: a summary, every change, and the paths, maps and curves of both runs. To
/// limit its size, only the rawlogs with the largest changes have paths, maps and curves.
std::string compare_html(const Comparison& comparison, const NamedRuns& runs);

}  // namespace flownav::regress
