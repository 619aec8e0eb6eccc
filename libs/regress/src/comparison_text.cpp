#include "flownav/regress/comparison_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "figure_text.h"
#include "flownav/cli/number_text.h"

namespace flownav::regress {

namespace {

constexpr std::size_t columns = 7;
using Row = std::array<std::string, columns>;
constexpr std::array<bool, columns> is_number = {false, false, true, true, true, true, false};

std::string severity_text(double severity) {
    return std::isfinite(severity) ? cli::fixed_text(severity, 1) : "";
}

Row row_of(const Change& change) {
    return {change.id,
            change.figure.empty() ? "outcome of the replay" : change.figure,
            change.before,
            change.after,
            change.difference,
            severity_text(change.severity),
            to_string(change.verdict)};
}

std::string line_of(const Row& row, const std::array<std::size_t, columns>& widths) {
    std::string line;
    for (std::size_t k = 0; k < columns; ++k) {
        const std::string blanks(widths[k] - std::min(widths[k], row[k].size()), ' ');
        line += (k == 0 ? "" : "  ") + (is_number[k] ? blanks + row[k] : row[k] + blanks);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
}

std::string list_of(const std::vector<std::string>& ids) {
    constexpr std::size_t most = 10;
    std::string text;
    for (std::size_t k = 0; k < std::min(most, ids.size()); ++k) text += (k == 0 ? "" : ", ") + ids[k];
    return ids.size() > most ? text + " and " + std::to_string(ids.size() - most) + " more" : text;
}

void add_rawlogs(const char* what, const std::vector<std::string>& ids, std::vector<std::string>& lines) {
    if (!ids.empty()) lines.push_back(what + std::string(": ") + list_of(ids));
}

}  // namespace

const char* to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::Worse:
            return "worse";
        case Verdict::Better:
            return "better";
        case Verdict::Unknown:
            break;
    }
    return "";
}

std::string change_table(const Comparison& comparison, std::size_t most) {
    if (comparison.changes.empty()) return "";
    std::vector<Row> rows = {{"rawlog", "figure", "A", "B", "change", "tolerances", ""}};
    const std::size_t shown = std::min(most, comparison.changes.size());
    for (std::size_t k = 0; k < shown; ++k) rows.push_back(row_of(comparison.changes[k]));
    std::array<std::size_t, columns> widths{};
    for (const Row& row : rows)
        for (std::size_t k = 0; k < columns; ++k) widths[k] = std::max(widths[k], row[k].size());
    std::string text;
    for (const Row& row : rows) text += line_of(row, widths);
    return text;
}

std::vector<std::string> what_differs(const Comparison& comparison) {
    std::vector<std::string> lines;
    if (comparison.program_before != comparison.program_after) {
        lines.push_back("program: " + comparison.program_before + " -> " + comparison.program_after);
    } else if (comparison.other_setup && comparison.settings.empty()) {
        lines.push_back("program: another file, of the same version " + comparison.program_before);
    }
    for (const SettingChange& setting : comparison.settings) {
        const bool everywhere = setting.rawlogs == comparison.ids.size();
        const std::string where = everywhere ? "" : " in " + count_text(setting.rawlogs, "rawlog");
        lines.push_back(setting.key + ": " + setting.before + " -> " + setting.after + where);
    }
    add_rawlogs("only in A", comparison.only_before, lines);
    add_rawlogs("only in B", comparison.only_after, lines);
    add_rawlogs("not the same recording", comparison.other_rawlog, lines);
    return lines;
}

std::string tally_text(const Tally& tally) {
    const std::string rawlogs = count_text(tally.rawlogs, "rawlog") + " in both runs";
    if (tally.rawlogs == 0) return "No rawlog is in both runs: nothing to compare.";
    if (tally.changed == 0) return rawlogs + ": every figure is the same.";
    const std::string changed = rawlogs + ", " + std::to_string(tally.changed) + " changed";
    if (tally.beyond == 0) return changed + ", all within tolerance.";
    std::string how;
    for (const auto& [number, words] :
         {std::pair(tally.worse, " worse"), std::pair(tally.better, " better"),
          std::pair(tally.neither, " in figures of which neither way is better")})
        if (number > 0) how += (how.empty() ? "" : ", ") + std::to_string(number) + words;
    return changed + ", " + std::to_string(tally.beyond) + " of them beyond tolerance: " + how + ".";
}

}  // namespace flownav::regress
