#pragma once

#include <optional>
#include <string>

#include "flownav/regress/figure_rules.h"

namespace flownav::regress {

/// Shortest text of a number; "null" without a value.
std::string value_text(const std::optional<double>& value);

/// Text such as "0.0229 -> 0.0243, up by 0.0014 (+6.1 %), worse".
std::string change_text(const std::string& figure, double before, double after);

/// Text such as "+0.0014 (+6.1 %)"; without the share when `before` is 0.
std::string difference_text(double before, double after);

/// Text such as "2 %" or "0.05".
std::string tolerance_text(const Tolerance& tolerance);

/// Text such as "1 rawlog" or "3 rawlogs".
std::string count_text(std::size_t number, const std::string& noun);

}  // namespace flownav::regress
