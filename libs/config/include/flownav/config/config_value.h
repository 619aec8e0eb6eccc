#pragma once
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace flownav::config {

/// A text that is not a value of its key; what() completes the sentence: "is not a number".
struct BadValue : std::invalid_argument {
    using std::invalid_argument::invalid_argument;
};

/// Shortest text that reads back as the same number, independent of the locale.
template <class T>
std::string format_number(T number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

/// Reads a number that fills the whole text. Throws BadValue: any other text, NaN and infinity included.
template <class T>
T parse_number(const std::string& text) {
    T number{};
    const char* const last = text.data() + text.size();
    const auto result = std::from_chars(text.data(), last, number);
    if (result.ec == std::errc::result_out_of_range) throw BadValue("is out of range");
    if (result.ec != std::errc{} || result.ptr != last || text.empty())
        throw BadValue(std::is_integral_v<T> ? "is not a whole number" : "is not a number");
    if constexpr (std::is_floating_point_v<T>) {
        if (!std::isfinite(number)) throw BadValue("is not a finite number");
    }
    return number;
}

/// An interval of allowed values, both ends included.
template <class T>
struct Range {
    T lowest;
    T highest;
};

template <class T>
std::string describe(const Range<T>& range) {
    return format_number(range.lowest) + " .. " + format_number(range.highest);
}

/// Throws BadValue also when the number lies outside the range.
template <class T>
T parse_number(const std::string& text, const Range<T>& range) {
    const T number = parse_number<T>(text);
    if (number < range.lowest || number > range.highest) throw BadValue("is out of range");
    return number;
}

}  // namespace flownav::config
