#pragma once
#include <cstdint>
#include <string>

#include "flownav/cli/number_text.h"

namespace flownav::evaluation {

/// Larger shares are told in a sentence.
constexpr double told_share = 0.02;

/// Page of share/doc about all sentences.
constexpr const char* findings_page = " (share/doc/odd_recordings.md)";

/// "13 of 15 images (87 %)".
inline std::string counted(std::uint64_t count, std::uint64_t of, const std::string& things) {
    const double percent = of > 0 ? 100.0 * static_cast<double>(count) / static_cast<double>(of) : 0.0;
    return std::to_string(count) + " of " + std::to_string(of) + ' ' + things + " (" +
           cli::fixed_text(percent, percent < 10.0 ? 1 : 0) + " %)";
}

}  // namespace flownav::evaluation
