#include "markdown.h"

#include <cmath>

#include "flownav/cli/number_text.h"

namespace flownav::fidelity {
namespace {

std::string line_of(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& text : cells) line += ' ' + text + " |";
    return line + '\n';
}

/// Text of a limit without trailing zeros.
std::string limit_text(double limit) {
    std::string text = cli::fixed_text(limit, 3);
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

std::string to_markdown(const Table& table) {
    std::string text = line_of(table.heads) + "|---|";
    for (std::size_t i = 1; i < table.heads.size(); ++i) text += "--:|";
    text += '\n';
    for (const auto& row : table.rows) text += line_of(row);
    return text + '\n';
}

std::string cell(double value, int decimals, const std::optional<Target>& target) {
    std::string text = cli::fixed_text(value, decimals);
    if (text.empty()) return "-";
    if (!target) return text;
    const double size = std::abs(value);
    const bool met = target->at_least ? size >= target->limit : size < target->limit;
    const std::string relation = met == target->at_least ? " ≥ " : " < ";
    return (met ? text : "**" + text + "**") + relation + limit_text(target->limit);
}

}  // namespace flownav::fidelity
