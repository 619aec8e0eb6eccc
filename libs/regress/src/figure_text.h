#pragma once

#include <optional>
#include <string>

#include "flownav/regress/figure_rules.h"

namespace flownav::regress {

/// A number without needless digits, "null" where there is none.
std::string value_text(const std::optional<double>& value);

/// "0.0229 -> 0.0243, up by 0.0014 (+6.1 %), worse".
std::string change_text(const std::string& figure, double before, double after);

/// "+0.0014 (+6.1 %)"; without a share where `before` is 0.
std::string difference_text(double before, double after);

/// "2 %" or "0.05".
std::string tolerance_text(const Tolerance& tolerance);

/// "1 rawlog", "3 rawlogs".
std::string count_text(std::size_t number, const std::string& noun);

}  // namespace flownav::regress
