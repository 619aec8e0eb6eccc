#include "flownav/io/time_unit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace flownav::io {
namespace {

struct UnitRow {
    TimeUnit unit;
    const char* key;
    const char* name;
    double seconds;
};

constexpr std::array<UnitRow, 4> units = {{{TimeUnit::Seconds, "s", "seconds", 1.0},
                                           {TimeUnit::Milliseconds, "ms", "milliseconds", 1e-3},
                                           {TimeUnit::Microseconds, "us", "microseconds", 1e-6},
                                           {TimeUnit::Nanoseconds, "ns", "nanoseconds", 1e-9}}};

const UnitRow& row_of(TimeUnit unit) {
    return *std::find_if(units.begin(), units.end(), [unit](const UnitRow& row) { return row.unit == unit; });
}

/// Images this far apart are never meant, so that a large number is no time since 1970 in that unit.
constexpr double rare_interval_s = 3600.0;

constexpr const char* advice = "tell the unit with --times-unit s|ms|us|ns";

/// Distances of the sorted values that differ, as their median and whether all of them are 1.
struct Intervals {
    long double median = 0.0L;
    bool all_one = true;
};

Intervals intervals_of(const std::vector<long double>& sorted) {
    std::vector<long double> differences;
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i] > sorted[i - 1]) differences.push_back(sorted[i] - sorted[i - 1]);
    if (differences.empty()) return {};
    Intervals result;
    for (const long double d : differences) result.all_one = result.all_one && d == 1.0L;
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>((differences.size() - 1) / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    result.median = *middle;
    return result;
}

/// Unit that makes a number a time of the years 2000 to 2100.
std::optional<TimeUnit> epoch_unit(long double value) {
    constexpr double year_2000_s = 946684800.0;
    for (const UnitRow& row : units) {
        const auto seconds = static_cast<double>(value * row.seconds);
        if (seconds >= year_2000_s && seconds <= latest_time_s) return row.unit;
    }
    return std::nullopt;
}

/// Unit that makes the distance of two images a usual one.
std::optional<TimeUnit> interval_unit(long double interval) {
    constexpr double longest_s = 2.0;
    for (const UnitRow& row : units) {
        const double shortest_s = row.unit == TimeUnit::Seconds ? 0.0005 : 0.008;
        const auto seconds = static_cast<double>(interval * row.seconds);
        if (seconds >= shortest_s && seconds < longest_s) return row.unit;
    }
    return std::nullopt;
}

std::string apart(long double interval, TimeUnit unit) {
    std::ostringstream text;
    text << static_cast<double>(interval * row_of(unit).seconds) << " s apart";
    return text.str();
}

bool possible(long double interval, long double last, TimeUnit unit) {
    const auto seconds = static_cast<double>(interval * row_of(unit).seconds);
    const bool usual = interval == 0 || (seconds >= 0.0002 && seconds <= 10.0);
    return usual && static_cast<double>(last * row_of(unit).seconds) <= latest_time_s;
}

UnitFinding recognised(TimeUnit unit, long double interval) {
    if (unit == TimeUnit::Seconds) return {unit, ""};
    return {unit, std::string("the times are taken for ") + row_of(unit).name + ", the images are then " +
                      apart(interval, unit) + " (--times-unit overrides this)"};
}

UnitFinding refused(const std::string& why) {
    return {std::nullopt, why + "; " + advice};
}

UnitFinding checked_name(TimeUnit named, long double interval, long double last) {
    if (possible(interval, last, named)) return {named, ""};
    const auto epoch = epoch_unit(last);
    if (epoch && possible(interval, last, *epoch)) {
        UnitFinding finding = recognised(*epoch, interval);
        finding.why = std::string("the header says ") + row_of(named).name + ", but the times are " +
                      row_of(*epoch).name + " since 1970 and are read as such (--times-unit overrides this)";
        return finding;
    }
    return refused(std::string("the header says ") + row_of(named).name + ", but the images would be " +
                   apart(interval, named) + " and the last time " +
                   std::to_string(static_cast<double>(last * row_of(named).seconds)) + " s");
}

}  // namespace

std::optional<TimeUnit> parse_time_unit(const std::string& text) {
    for (const UnitRow& row : units)
        if (text == row.key) return row.unit;
    return std::nullopt;
}

const char* name_of(TimeUnit unit) {
    return row_of(unit).name;
}

double seconds_of(TimeUnit unit) {
    return row_of(unit).seconds;
}

UnitFinding find_time_unit(std::vector<long double> values, const UnitHints& hints) {
    if (hints.asked) return {hints.asked, ""};
    if (values.empty()) return {TimeUnit::Seconds, ""};
    std::sort(values.begin(), values.end());
    const Intervals intervals = intervals_of(values);
    const long double interval = intervals.median;
    const auto epoch = epoch_unit(values[values.size() / 2]);
    if (hints.named) return checked_name(*hints.named, interval, values.back());
    if (interval == 0) return epoch ? recognised(*epoch, 0) : UnitFinding{TimeUnit::Seconds, ""};
    if (intervals.all_one && !epoch)
        return refused("the times rise by exactly 1; if they are numbers of images, give --rate HZ instead");
    const auto usual = interval_unit(interval);
    if (epoch && (usual == epoch || (!usual && possible(interval, values.back(), *epoch))))
        return recognised(*epoch, interval);
    if (epoch && usual && static_cast<double>(interval) * seconds_of(*epoch) < rare_interval_s) {
        return refused("the images would be " + apart(interval, *epoch) + " as " + row_of(*epoch).name +
                       " since 1970 and " + apart(interval, *usual) + " as " + row_of(*usual).name);
    }
    if (usual) return recognised(*usual, interval);
    return refused("the times rise by " + std::to_string(static_cast<double>(interval)) +
                   " from image to image, which is usual in no unit");
}

}  // namespace flownav::io
