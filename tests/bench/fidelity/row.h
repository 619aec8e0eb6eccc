#pragma once
#include <string>

#include "score.h"

namespace flownav::fidelity {

/// Headings of the columns of row_of(), two lines.
std::string row_heads();

/// Returns the figures of a score in one line of text.
std::string row_of(const std::string& name, const Score& score);

/// Returns the detection by kind of object (rows) and range (columns), and the labels of the blocks to
/// detect; several lines.
std::string detection_of(const Score& score);

}  // namespace flownav::fidelity
