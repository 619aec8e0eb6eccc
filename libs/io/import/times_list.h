#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "flownav/io/time_unit.h"

namespace flownav::io {

/// A row of a file with times.
struct TimesRow {
    std::size_t line = 0;  ///< in the file, counted from 1
    double time_s = 0.0;
    std::string image;                   ///< name of the image; empty when the file has no names
    std::optional<std::size_t> number;   ///< number of the image; empty when the file has no numbers
    std::optional<double> gyro_z_radps;  ///< > 0 to the left
};

/// Times of images from a file, in the order of its rows.
struct TimesList {
    std::filesystem::path file;
    std::vector<TimesRow> rows;
    bool has_names = false;
    bool has_numbers = false;
    std::vector<std::string> notes;  ///< what was recognised, one sentence each
};

/// Reads a file with times. The column of the times has a known name, or is the first that holds times; a
/// column of names is recognised by its header, or by `stems`: the names of the images without folder and
/// ending. Throws InputError: no times, a time that is no number, negative or beyond 2100, or whose unit is
/// not known.
TimesList read_times_list(const std::filesystem::path& file, std::optional<TimeUnit> unit,
                          const std::vector<std::string>& stems);

/// Throws InputError unless each time is later than the one before.
void require_rising(const TimesList& list);

}  // namespace flownav::io
