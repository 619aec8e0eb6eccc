#include "written_time.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>

namespace flownav::io {
namespace {

std::optional<long double> number(const std::string& text) {
    if (text.empty() || text.find_first_of("xXnN") != std::string::npos) return std::nullopt;
    char* end = nullptr;
    const long double value = std::strtold(text.c_str(), &end);
    if (end == text.c_str() || *end != '\0' || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// Fraction of a second such as ".964"; moves `rest` behind it.
long double fraction_at(const char*& rest) {
    if (*rest != '.' && *rest != ',') return 0.0L;
    long double fraction = 0.0L;
    long double digit = 0.1L;
    for (++rest; *rest >= '0' && *rest <= '9'; ++rest, digit /= 10) fraction += digit * (*rest - '0');
    return fraction;
}

/// Seconds that a zone such as "Z" or "+02:00" is ahead of UTC; empty for other text.
std::optional<long> zone_s(const std::string& text) {
    if (text.empty() || text == "Z" || text == "z" || text == " UTC" || text == "UTC") return 0;
    std::string digits = text.substr(1);
    if (const auto colon = digits.find(':'); colon != std::string::npos) digits.erase(colon, 1);
    const bool sign = text.front() == '+' || text.front() == '-';
    if (!sign || (digits.size() != 2 && digits.size() != 4)) return std::nullopt;
    if (digits.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
    const long hours = std::stol(digits.substr(0, 2));
    const long minutes = digits.size() == 4 ? std::stol(digits.substr(2)) : 0;
    return (text.front() == '-' ? -60L : 60L) * (60 * hours + minutes);
}

std::optional<long double> date(const std::string& text) {
    for (const char* format :
         {"%Y-%m-%d %H:%M:%S", "%Y-%m-%dT%H:%M:%S", "%Y/%m/%d %H:%M:%S", "%Y%m%dT%H%M%S"}) {
        std::tm parts{};
        const char* rest = strptime(text.c_str(), format, &parts);
        if (rest == nullptr) continue;
        const long double fraction = fraction_at(rest);
        const auto zone = zone_s(rest);
        if (!zone) return std::nullopt;
        return static_cast<long double>(timegm(&parts) - *zone) + fraction;
    }
    return std::nullopt;
}

}  // namespace

std::optional<WrittenTime> parse_written_time(const std::string& text) {
    if (const auto value = number(text)) return WrittenTime{*value, false};
    const auto seconds = date(text);
    if (!seconds || *seconds < 0) return std::nullopt;
    return WrittenTime{*seconds, true};
}

std::string date_text(double seconds_since_1970) {
    const auto whole = static_cast<std::time_t>(seconds_since_1970);
    std::tm parts{};
    gmtime_r(&whole, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts);
    return text.data();
}

}  // namespace flownav::io
