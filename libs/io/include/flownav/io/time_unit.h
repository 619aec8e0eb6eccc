#pragma once
#include <optional>
#include <string>
#include <vector>

namespace flownav::io {

enum class TimeUnit { Seconds, Milliseconds, Microseconds, Nanoseconds };

/// Parses s, ms, us or ns; empty for other text.
std::optional<TimeUnit> parse_time_unit(const std::string& text);

/// Name of a unit, such as "milliseconds".
const char* name_of(TimeUnit unit);

double seconds_of(TimeUnit unit);

/// Latest time that is believed, in seconds since 1970: the year 2100.
constexpr double latest_time_s = 4102444800.0;

/// Unit of written times: asked for, named by the text, or recognised from the values.
struct UnitFinding {
    std::optional<TimeUnit> unit;  ///< empty: refused
    std::string why;               ///< how the unit was recognised, or why it was not; empty: nothing to tell
};

/// What a text says about the unit of its times.
struct UnitHints {
    std::optional<TimeUnit> asked;  ///< by the user; is followed
    std::optional<TimeUnit> named;  ///< by the header of the column; is followed unless it is impossible
};

/// Finds the unit of the times of consecutive images, in any order. Without hints it is the one that makes
/// the images 0.5 ms .. 2 s apart (8 ms .. 2 s when it is not the second), or, for times since 1970, the one
/// that leads to a year from 2000 to 2100.
UnitFinding find_time_unit(std::vector<long double> values, const UnitHints& hints);

}  // namespace flownav::io
