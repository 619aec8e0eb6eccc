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

/// What a figure should be: at most `limit` in magnitude, or at least.
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

/// A figure beside its target: "0.012 < 0.025", or in bold with the relation that holds when it is missed.
/// "-" when it was not measured.
std::string cell(double value, int decimals, const std::optional<Target>& target = std::nullopt);

}  // namespace flownav::fidelity
