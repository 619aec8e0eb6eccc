#pragma once
#include <optional>
#include <string>

namespace flownav::io {

/// A time as a text holds it: a number whose unit is not known yet, or a date with its time of day, which is
/// in seconds since 1970.
struct WrittenTime {
    long double value = 0.0L;  ///< wide enough for nanoseconds since 1970
    bool date = false;
};

/// Parses a number, or a date such as 2011-09-26 13:02:25.964389445, 2011-09-26T13:02:25Z or
/// 2011/09/26 13:02:25+02:00 (UTC without a zone). Empty for other text, negative dates and infinite numbers.
std::optional<WrittenTime> parse_written_time(const std::string& text);

/// Day and time of day in UTC, such as "2013-06-24 17:22:59".
std::string date_text(double seconds_since_1970);

}  // namespace flownav::io
