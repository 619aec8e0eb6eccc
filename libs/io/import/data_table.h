#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace flownav::io {

/// A line of a text file, split into its cells without blanks and quotes around them.
struct TableRow {
    std::size_t line = 0;  ///< counted from 1
    std::vector<std::string> cells;
};

/// A table of a text file. Cells are separated by semicolons, commas or tabs, else by blanks; a date and its
/// time of day are one cell, and so are a name and its unit in brackets. Lines that begin with # or % are
/// comments.
struct DataTable {
    std::filesystem::path file;
    std::vector<std::string> comment;  ///< cells of the last comment before the first row
    std::vector<TableRow> rows;
};

/// Reads a table; a byte order mark, Windows line ends and empty lines are skipped. Throws InputError: the
/// file cannot be read, is empty, or is UTF-16.
DataTable read_table(const std::filesystem::path& file);

/// Cells of one line.
std::vector<std::string> cells_of(const std::string& line);

std::string lower_case(std::string text);

}  // namespace flownav::io
