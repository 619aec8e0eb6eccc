#include "times_list.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "flownav/io/errors.h"
#include "flownav/math/units.h"
#include "times_columns.h"
#include "written_time.h"

namespace flownav::io {
namespace {

std::string place_of(const DataTable& table, const TableRow& row) {
    return table.file.string() + ", line " + std::to_string(row.line);
}

/// Explains text that is no number.
std::string why_no_number(const std::string& cell) {
    const bool comma =
        cell.find(',') != std::string::npos && cell.find_first_not_of("+-0123456789,") == std::string::npos;
    return comma ? " (write numbers with a decimal point)" : "";
}

WrittenTime time_in(const DataTable& table, const TableRow& row, std::size_t column) {
    const std::string cell = column < row.cells.size() ? row.cells[column] : "";
    const auto time = parse_written_time(cell);
    if (!time)
        throw InputError(place_of(table, row) + ": holds no time: '" + cell + "'" + why_no_number(cell));
    if (time->value < 0) throw InputError(place_of(table, row) + ": the time " + cell + " is negative");
    return *time;
}

double gyro_in(const DataTable& table, const TableRow& row, const TimesColumns& columns) {
    const std::string cell = *columns.gyro < row.cells.size() ? row.cells[*columns.gyro] : "";
    const auto rate = parse_written_time(cell);
    if (!rate || rate->date)
        throw InputError(place_of(table, row) + ": holds no turn rate: '" + cell + "'" + why_no_number(cell));
    return static_cast<double>(rate->value) * (columns.gyro_in_degrees ? degree_rad : 1.0);
}

std::optional<std::size_t> number_in(const TableRow& row, std::size_t column) {
    const std::string cell = column < row.cells.size() ? row.cells[column] : "";
    if (cell.empty() || cell.size() > 18 || cell.find_first_not_of("0123456789") != std::string::npos)
        return std::nullopt;
    return std::stoull(cell);
}

/// Written times of all rows below the header.
std::vector<WrittenTime> written_times(const DataTable& table, const TimesColumns& columns) {
    std::vector<WrittenTime> times;
    for (std::size_t i = columns.header_row ? 1 : 0; i < table.rows.size(); ++i)
        times.push_back(time_in(table, table.rows[i], columns.time));
    if (times.empty()) throw InputError(table.file.string() + ": holds no times below its header");
    return times;
}

/// Refuses stamps without a fraction that several images share.
void refuse_shared_seconds(const DataTable& table, const std::vector<WrittenTime>& times) {
    std::size_t shared = 0;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (times[i].value != static_cast<long double>(static_cast<long long>(times[i].value))) return;
        if (times[i].value == times[i - 1].value) ++shared;
    }
    if (times.size() < 4 || 3 * shared < times.size()) return;
    throw InputError(
        table.file.string() + ": " + std::to_string(shared) + " of " + std::to_string(times.size()) +
        " images have the time of the image before: the times are cut off to whole numbers; give "
        "finer times, or --rate HZ");
}

/// Factor from written times to seconds.
long double scale_of(const DataTable& table, const std::vector<WrittenTime>& times, const UnitHints& hints,
                     std::vector<std::string>& notes) {
    if (times.front().date) return 1.0L;
    std::vector<long double> values;
    for (const WrittenTime& time : times) values.push_back(time.value);
    const UnitFinding finding = find_time_unit(values, hints);
    if (!finding.unit) throw InputError(table.file.string() + ": " + finding.why);
    if (!finding.why.empty()) notes.push_back(table.file.string() + ": " + finding.why);
    return 1.0L / static_cast<long double>(std::llround(1.0 / seconds_of(*finding.unit)));
}

TimesRow row_of(const DataTable& table, const TableRow& row, const TimesColumns& columns) {
    TimesRow result;
    result.line = row.line;
    if (columns.name && *columns.name < row.cells.size()) result.image = stem_of(row.cells[*columns.name]);
    if (columns.number) result.number = number_in(row, *columns.number);
    if (columns.gyro) result.gyro_z_radps = gyro_in(table, row, columns);
    return result;
}

void require_no_far_time(const DataTable& table, const TimesRow& row) {
    if (row.time_s <= latest_time_s) return;
    std::ostringstream text;
    text << table.file.string() << ", line " << row.line << ": the time " << std::fixed << row.time_s
         << " s is beyond the year 2100; correct it, or tell the unit with --times-unit s|ms|us|ns";
    throw InputError(text.str());
}

}  // namespace

TimesList read_times_list(const std::filesystem::path& file, std::optional<TimeUnit> unit,
                          const std::vector<std::string>& stems) {
    const DataTable table = read_table(file);
    const TimesColumns columns = find_times_columns(table, stems);
    const std::vector<WrittenTime> times = written_times(table, columns);
    refuse_shared_seconds(table, times);
    TimesList list;
    list.file = file;
    list.has_names = columns.name.has_value();
    list.has_numbers = columns.number.has_value();
    const long double scale = scale_of(table, times, {unit, columns.unit}, list.notes);
    const std::size_t first = columns.header_row ? 1 : 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        TimesRow row = row_of(table, table.rows[first + i], columns);
        if (times[i].date != times.front().date)
            throw InputError(place_of(table, table.rows[first + i]) + ": mixes numbers and dates");
        row.time_s = static_cast<double>(times[i].value * scale);
        require_no_far_time(table, row);
        list.has_numbers = list.has_numbers && row.number.has_value();
        list.rows.push_back(std::move(row));
    }
    return list;
}

void require_rising(const TimesList& list) {
    const bool whole = std::all_of(list.rows.begin(), list.rows.end(),
                                   [](const TimesRow& row) { return row.time_s == std::floor(row.time_s); });
    for (std::size_t i = 1; i < list.rows.size(); ++i) {
        if (list.rows[i].time_s > list.rows[i - 1].time_s) continue;
        throw InputError(list.file.string() + ", line " + std::to_string(list.rows[i].line) +
                         ": its time is not later than the one before; correct it, or use --rate" +
                         (whole ? " (write numbers with a decimal point, not with a comma)" : ""));
    }
}

}  // namespace flownav::io
