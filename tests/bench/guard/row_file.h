#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenario.h"

namespace flownav {

/// The runs so far; a missing file holds none.
std::vector<RunRow> read_rows(const std::filesystem::path& path);
void append_row(const std::filesystem::path& path, const RunRow& row);

/// One line of markdown a fault.
std::string table_of(const std::vector<RunRow>& rows);

}  // namespace flownav
