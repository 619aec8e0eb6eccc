#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario.h"

namespace flownav {

/// Reads the runs so far; empty for a missing file.
std::vector<RunRow> read_rows(const std::filesystem::path& path);
void append_row(const std::filesystem::path& path, const RunRow& row);

/// Markdown table with one line per fault.
std::string table_of(const std::vector<RunRow>& rows);

}  // namespace flownav
