#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace flownav::regress {

/// Columns of equal length by name; not a number where a cell is empty or a word.
using Columns = std::map<std::string, std::vector<double>>;

/// A CSV whose first line names the columns; nothing where there is no such file.
Columns read_csv(const std::filesystem::path& file);

/// A trajectory in TUM format: timestamp, x, y.
Columns read_tum(const std::filesystem::path& file);

}  // namespace flownav::regress
