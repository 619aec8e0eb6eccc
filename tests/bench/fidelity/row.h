#pragma once
#include <string>

#include "score.h"

namespace flownav::fidelity {

/// The heads of the columns of row_of(), two lines.
std::string row_heads();

/// The figures of a score in one line of text.
std::string row_of(const std::string& name, const Score& score);

/// Detection by kind of thing (rows) and range (columns), and what became of the blocks to detect; several
/// lines.
std::string detection_of(const Score& score);

}  // namespace flownav::fidelity
