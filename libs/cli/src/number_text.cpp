#include "flownav/cli/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace flownav::cli {

std::string fixed_text(double value, int decimals) {
    if (!std::isfinite(value)) return "";
    std::array<char, 512> buffer{};  // the largest double has 309 digits before the point
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::fixed, decimals);
    std::string text(buffer.data(), end.ptr);
    const bool zero = text.find_first_not_of("-0.") == std::string::npos;
    if (zero && text.front() == '-') text.erase(0, 1);
    return text;
}

std::string time_text(double timestamp_s) {
    return fixed_text(timestamp_s, 6);
}

}  // namespace flownav::cli
