#include "times_columns.h"

#include <algorithm>
#include <array>
#include <set>

#include "flownav/io/errors.h"
#include "import_files.h"
#include "written_time.h"

namespace flownav::io {
namespace {

using Cells = std::vector<std::string>;

struct TimeName {
    std::string base;
    std::optional<TimeUnit> unit;
};

/// Splits the name of a column such as "timestamp [ns]", "time_ms" or "stamp(us)".
TimeName time_name(const std::string& cell) {
    std::string name = lower_case(cell);
    name.erase(std::remove_if(name.begin(), name.end(), [](char c) { return c == ')' || c == ']'; }),
               name.end());
    const auto cut = name.find_last_of("_[( ");
    if (cut == std::string::npos) return {name, std::nullopt};
    std::string unit = name.substr(cut + 1);
    if (unit == "sec" || unit == "secs" || unit == "seconds") unit = "s";
    if (unit == "nsec" || unit == "nanoseconds") unit = "ns";
    if (unit == "usec" || unit == "microseconds") unit = "us";
    if (unit == "msec" || unit == "milliseconds") unit = "ms";
    const auto known = parse_time_unit(unit);
    if (!known) return {name, std::nullopt};
    return {name.substr(0, name.find_last_not_of("_[( ", cut) + 1), known};
}

template <std::size_t N>
bool one_of(const std::string& name, const std::array<const char*, N>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_time(const std::string& cell) {
    static constexpr std::array<const char*, 14> names = {
        "timestamp",  "timestamps", "time",     "times",    "stamp",        "t",
        "time_stamp", "unix_time",  "unixtime", "datetime", "header.stamp", "field.header.stamp",
        "utc",        "epoch"};
    return one_of(time_name(cell).base, names);
}

bool is_name(const std::string& cell) {
    static constexpr std::array<const char*, 12> names = {"filename",   "file",       "file_name", "name",
                                                          "image",      "image_name", "img",       "path",
                                                          "image_path", "image_file", "picture",   "rgb"};
    return one_of(lower_case(cell), names);
}

bool is_number(const std::string& cell) {
    static constexpr std::array<const char*, 12> names = {
        "index", "frame",    "frame_id", "frame_number", "number", "id",
        "seq",   "image_id", "idx",      "image_number", "no",     "frame_index"};
    return one_of(lower_case(cell), names);
}

template <class Test>
std::optional<std::size_t> column_where(const Cells& cells, Test test) {
    const auto found = std::find_if(cells.begin(), cells.end(), test);
    if (found == cells.end()) return std::nullopt;
    return static_cast<std::size_t>(found - cells.begin());
}

bool holds_data(const Cells& cells) {
    return std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
        return parse_written_time(cell).has_value() || has_picture_ending(cell);
    });
}

void read_header(const Cells& header, TimesColumns& columns) {
    columns.name = column_where(header, is_name);
    columns.number = column_where(header, is_number);
    columns.gyro = column_where(header, [](const std::string& cell) { return cell == "gyro_z_degps"; });
    columns.gyro_in_degrees = columns.gyro.has_value();
    if (!columns.gyro)
        columns.gyro = column_where(header, [](const std::string& cell) { return cell == "gyro_z_radps"; });
}

/// First column whose cells all fulfil `test`, among the columns that the first data row has.
template <class Test>
std::optional<std::size_t> column_of_cells(const DataTable& table, std::size_t first_row, Test test) {
    if (first_row >= table.rows.size()) return std::nullopt;
    for (std::size_t column = 0; column < table.rows[first_row].cells.size(); ++column) {
        const bool all = std::all_of(
            table.rows.begin() + static_cast<std::ptrdiff_t>(first_row), table.rows.end(),
            [&](const TableRow& row) { return column < row.cells.size() && test(row.cells[column]); });
        if (all) return column;
    }
    return std::nullopt;
}

/// Column of names by what it holds: names of pictures, or the stems of more than half of the images.
std::optional<std::size_t> name_column(const DataTable& table, std::size_t first_row, const Cells& stems) {
    if (const auto column = column_of_cells(table, first_row, has_picture_ending)) return column;
    const std::set<std::string> known(stems.begin(), stems.end());
    if (first_row >= table.rows.size()) return std::nullopt;
    for (std::size_t column = 0; column < table.rows[first_row].cells.size(); ++column) {
        std::set<std::string> named;
        for (std::size_t i = first_row; i < table.rows.size(); ++i)
            if (column < table.rows[i].cells.size() && known.count(table.rows[i].cells[column]) > 0)
                named.insert(table.rows[i].cells[column]);
        if (2 * named.size() > known.size()) return column;
    }
    return std::nullopt;
}

/// First column with times, preferably another than that of the names.
std::optional<std::size_t> time_column(const Cells& first, const std::optional<std::size_t>& name) {
    for (const bool also_names : {false, true})
        for (std::size_t column = 0; column < first.size(); ++column)
            if (parse_written_time(first[column]) && (also_names || column != name)) return column;
    return std::nullopt;
}

/// Throws the error for a header without a known name of times.
[[noreturn]] void refuse_header(const DataTable& table) {
    throw InputError(table.file.string() +
                     ": has no column timestamp_s, timestamp, time_s or time; name one with --times, or use "
                     "--rate");
}

}  // namespace

std::string stem_of(const std::string& name) {
    const auto slash = name.find_last_of("/\\");
    const std::string file = slash == std::string::npos ? name : name.substr(slash + 1);
    return has_picture_ending(file) ? file.substr(0, file.find_last_of('.')) : file;
}

TimesColumns find_times_columns(const DataTable& table, const Cells& stems) {
    TimesColumns columns;
    const Cells& first = table.rows.front().cells;
    columns.header_row = !holds_data(first);
    const Cells& header = columns.header_row ? first : table.comment;
    const auto named_time = column_where(header, is_time);
    if (columns.header_row && !named_time) refuse_header(table);
    if (named_time) read_header(header, columns);
    const std::size_t first_row = columns.header_row ? 1 : 0;
    if (!columns.name) columns.name = name_column(table, first_row, stems);
    if (named_time) {
        columns.time = *named_time;
        columns.unit = time_name(header[*named_time]).unit;
    } else if (const auto time = time_column(first, columns.name)) {
        columns.time = *time;
    } else {
        throw InputError(table.file.string() + ", line " + std::to_string(table.rows.front().line) +
                         ": holds no time");
    }
    const bool counters = columns.name == columns.time && first_row < table.rows.size() &&
                          table.rows[first_row].cells[columns.time].size() < 9;
    if (counters) columns.name.reset();
    return columns;
}

}  // namespace flownav::io
