#pragma once
#include <string>

namespace flownav::report {

/// A figure of summary.json in words.
struct FigureWords {
    const char*
        key;  ///< as in "drive.path_m"; of the errors without the track compared with: "errors.path_m"
    const char* unit;
    const char* meaning;
    const char* usual;  ///< what to expect; empty where nothing is usual
};

/// Null for an unknown figure.
const FigureWords* figure_words(const std::string& key);

/// Why something was left out, or used with a warning, as counted in summary.json; says so when it does not
/// know the reason.
std::string reason_words(const std::string& reason);

}  // namespace flownav::report
