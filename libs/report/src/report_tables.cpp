#include "report_tables.h"

#include "flownav/cli/number_text.h"
#include "flownav/evaluation/summary_facts.h"
#include "flownav/report/html.h"
#include "report_series.h"
#include "report_words.h"

namespace flownav::report {

namespace {

using html::Cell;
using html::row;
using Json = nlohmann::ordered_json;

Cell number(std::uint64_t count) {
    return {std::to_string(count), true};
}

/// A value as people read it; a dash where there is none.
Cell value_cell(const Json& value) {
    if (value.is_string()) return {value.get<std::string>()};
    if (value.is_number_float()) {
        const double number = value.get<double>();
        return {cli::fixed_text(number, std::abs(number) < 1e5 ? 3 : 1), true};
    }
    return {value.is_null() ? "-" : value.dump(), true};
}

std::vector<Cell> explained(std::vector<Cell> cells, const std::string& key) {
    const FigureWords* words = figure_words(key);
    cells.emplace_back(words != nullptr ? words->unit : "");
    cells.emplace_back(words != nullptr ? words->meaning : "not described");
    cells.emplace_back(words != nullptr ? words->usual : "");
    return cells;
}

std::string joined(const std::string& path, const std::string& name) {
    return std::string(path).append(".").append(name);
}

/// A row for every figure of a part of the summary; lists of warnings stand elsewhere.
std::string figure_rows(const Json& part, const std::string& path) {
    std::string rows;
    for (const auto& [name, value] : part.items()) {
        const std::string key = joined(path, name);
        if (value.is_array()) continue;
        if (!value.is_object()) {
            rows += row(explained({name, value_cell(value)}, key), key);
            continue;
        }
        for (const auto& [label, count] : value.items()) {
            const std::string own_key = joined(key, label);
            const bool has_words = figure_words(own_key) != nullptr;
            rows += row(explained({label, value_cell(count)}, has_words ? own_key : key), own_key);
        }
    }
    return rows;
}

std::string figures(const Json& summary, const std::string& path) {
    return html::table({{"figure"}, {"value", true}, {"unit"}, {"meaning"}, {"usual"}},
                       figure_rows(summary.at(path), path));
}

std::string errors(const Json& errors) {
    const Json& truth = errors.at("ground_truth");
    const Json& odometry = errors.at("odometry");
    if (truth.is_null() && odometry.is_null()) {
        return html::paragraph(
            "The recording has neither odometry nor ground truth to compare the flow odometry with.");
    }
    std::string rows;
    for (const auto& [name, unused] : (truth.is_null() ? odometry : truth).items()) {
        std::vector<Cell> cells = {name};
        if (!truth.is_null()) cells.push_back(value_cell(truth.at(name)));
        if (!odometry.is_null()) cells.push_back(value_cell(odometry.at(name)));
        rows += row(explained(std::move(cells), "errors." + name), "errors." + name);
    }
    std::vector<Cell> head = {{"figure"}};
    if (!truth.is_null()) head.emplace_back("against ground truth", true);
    if (!odometry.is_null()) head.emplace_back("against odometry", true);
    head.insert(head.end(), {{"unit"}, {"meaning"}, {"usual"}});
    return html::table(head, rows) +
           html::paragraph(
               "A dash stands for a figure that could not be computed. Poses of the other track are "
               "interpolated at the times of the fields; the first " +
               std::to_string(evaluation::Errors::settling_fields) +
               " fields, in which the sensor finds its first prediction, are left out of the "
               "figures of turn rate and speed. What is usual holds against ground truth; odometry has "
               "errors of its own.");
}

std::string statuses(const std::vector<evaluation::FieldRow>& rows) {
    const auto counts = evaluation::status_counts(rows);
    std::string lines;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const FieldStatus status = all_field_statuses.at(i);
        Cell name(to_string(status));
        name.mark = colour_of(status).css();
        const double share =
            rows.empty() ? 0.0 : 100.0 * static_cast<double>(counts[i]) / static_cast<double>(rows.size());
        lines +=
            row({name, number(counts[i]), {cli::fixed_text(share, 1), true}, {evaluation::explain(status)}},
                std::string("status.") + to_string(status));
    }
    return html::table({{"status"}, {"fields", true}, {"%", true}, {"meaning"}}, lines);
}

std::string rejected(const io::InputCounts& read) {
    std::string rows;
    for (const auto& [reason, count] : read.rejected)
        rows += row({reason, number(count), {"left out"}, {reason_words(reason)}}, "rejected." + reason);
    for (const auto& [warning, count] : read.warnings) {
        rows += row({warning, number(count), {"used all the same"}, {reason_words(warning)}},
                    "used_nevertheless." + warning);
    }
    if (rows.empty()) return html::paragraph("Nothing was rejected.");
    return html::table({{"reason"}, {"count", true}, {"what became of it"}, {"in words"}}, rows);
}

std::string configuration(const Json& config) {
    std::string rows;
    for (const config::ConfigKey& key : config::config_keys()) {
        const std::string value = config.at(key.section).at(key.name).get<std::string>();
        const bool changed = value != key.default_value;
        rows += row({key.section + "." + key.name, value, changed ? "default: " + key.default_value : "",
                     key.unit, key.range, key.help},
                    "config." + key.section + "." + key.name);
    }
    return "<details><summary>Every key as it was used</summary>\n" +
           html::table({{"key"}, {"value"}, {"changed"}, {"unit"}, {"range"}, {"meaning"}}, rows) +
           "</details>\n";
}

}  // namespace

std::string report_tables(const evaluation::Drive& drive, const config::Config& config) {
    const Json summary = evaluation::summary_facts(drive, config);
    std::string html = html::section("Flow odometry compared", errors(summary.at("errors")));
    if (!summary.at("drive").is_null()) html += html::section("The drive", figures(summary, "drive"));
    html += html::section("Status of the fields", statuses(drive.rows));
    html += html::section("Where the motion came from", figures(summary, "motion"));
    html += html::section("Contact scan", figures(summary, "contacts"));
    html += html::section("Why fields were bad", figures(summary, "bad_fields"));
    html += html::section("What was rejected, and why", rejected(drive.read));
    html += html::section("What was read", figures(summary, "read"));
    html += html::section("What was written", figures(summary, "written"));
    html += html::section("Check of the camera's pose", figures(summary, "camera_check"));
    return html + html::section("Configuration", configuration(summary.at("config")));
}

}  // namespace flownav::report
