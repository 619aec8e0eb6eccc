#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace flownav::regress {

/// Columns of equal length by name; NaN for a cell that is empty or not a number.
using Columns = std::map<std::string, std::vector<double>>;

/// Reads a CSV whose first line names the columns; empty for a missing file.
Columns read_csv(const std::filesystem::path& file);

/// Reads timestamp, x and y of a trajectory in TUM format.
Columns read_tum(const std::filesystem::path& file);

}  // namespace flownav::regress
