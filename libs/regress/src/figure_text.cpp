#include "figure_text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace flownav::regress {

namespace {

std::string digits(double value, const char* format) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

/// Change as a share of `before`; empty when the share is not defined.
std::string percent_text(double before, double after) {
    if (before == 0.0) return "";
    return " (" + digits(100.0 * (after - before) / std::abs(before), "%+.1f") + " %)";
}

}  // namespace

std::string value_text(const std::optional<double>& value) {
    return value ? digits(*value, "%.10g") : "null";
}

std::string change_text(const std::string& figure, double before, double after) {
    const double change = after - before;
    const int verdict = verdict_on(figure_rule(figure, before).better, before, after);
    return value_text(before) + " -> " + value_text(after) + (change > 0 ? ", up by " : ", down by ") +
           digits(std::abs(change), "%.6g") + percent_text(before, after) +
           (verdict > 0   ? ", better"
            : verdict < 0 ? ", worse"
                          : "");
}

std::string difference_text(double before, double after) {
    return digits(after - before, "%+.6g") + percent_text(before, after);
}

std::string tolerance_text(const Tolerance& tolerance) {
    return tolerance.relative ? digits(100.0 * tolerance.value, "%.6g") + " %"
                              : digits(tolerance.value, "%.6g");
}

std::string count_text(std::size_t number, const std::string& noun) {
    return std::to_string(number) + ' ' + noun + (number == 1 ? "" : "s");
}

}  // namespace flownav::regress
