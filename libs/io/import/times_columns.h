#pragma once
#include <optional>
#include <string>
#include <vector>

#include "data_table.h"
#include "flownav/io/time_unit.h"

namespace flownav::io {

/// Which column of a file with times holds what.
struct TimesColumns {
    bool header_row = false;  ///< the first row holds the names of the columns
    std::size_t time = 0;
    std::optional<TimeUnit> unit;  ///< named by the header
    std::optional<std::size_t> name;
    std::optional<std::size_t> number;
    std::optional<std::size_t> gyro;
    bool gyro_in_degrees = false;
};

/// Finds the columns by their names and, where these are missing, by what they hold. `stems`: names of the
/// images without ending. Throws InputError when no column holds times.
TimesColumns find_times_columns(const DataTable& table, const std::vector<std::string>& stems);

/// Name of a file without folders and ending; the whole text when it has no picture's ending.
std::string stem_of(const std::string& name);

}  // namespace flownav::io
