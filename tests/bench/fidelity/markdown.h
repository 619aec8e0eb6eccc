#pragma once
#include <optional>
#include <string>
#include <vector>

namespace flownav::fidelity {

/// A table in markdown.
struct Table {
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> rows;
};

std::string to_markdown(const Table& table);

/// Target of a figure: its magnitude is at most `limit`, or at least `limit`.
struct Target {
    double limit = 0.0;
    bool at_least = false;
};

inline Target below(double limit) {
    return {limit, false};
}
inline Target above(double limit) {
    return {limit, true};
}

/// Text of a figure with its target: "0.012 < 0.025", or in bold with the actual relation when it is missed.
/// "-" when it was not measured.
std::string cell(double value, int decimals, const std::optional<Target>& target = std::nullopt);

}  // namespace flownav::fidelity
