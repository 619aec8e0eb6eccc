#include "compare_page.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "figure_text.h"
#include "flownav/regress/comparison_text.h"
#include "flownav/regress/drive_pair.h"
#include "flownav/report/html.h"
#include "flownav/report/palette.h"
#include "pages.h"

namespace flownav::regress {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_drives = 30;

const RawlogResult& result_of(const std::string& id, const RunResults& results) {
    return *std::find_if(results.begin(), results.end(),
                         [&id](const RawlogResult& rawlog) { return rawlog.id == id; });
}

/// Numbers that JSON cannot hold become null.
Json changes_json(const Comparison& comparison) {
    Json changes = Json::array();
    for (const Change& change : comparison.changes) {
        changes.push_back({{"id", change.id},
                           {"figure", change.figure},
                           {"a", change.before},
                           {"b", change.after},
                           {"difference", change.difference},
                           {"share", change.share ? Json(*change.share) : Json(nullptr)},
                           {"severity", change.severity},
                           {"verdict", to_string(change.verdict)}});
    }
    return changes;
}

Json drives_json(const Comparison& comparison, const NamedRuns& runs) {
    Json drives = Json::object();
    for (std::size_t k = 0; k < std::min(most_drives, comparison.ids.size()); ++k) {
        const std::string& id = comparison.ids[k];
        drives[id] = drive_pair(result_of(id, runs.before), result_of(id, runs.after));
    }
    return drives;
}

std::string summary_html(const Comparison& comparison) {
    const Tally tally = tally_of(comparison);
    const bool complete = comparison.only_before.empty() && comparison.only_after.empty();
    const bool bad = !complete || tally.rawlogs == 0 || tally.worse > 0;
    const char* const look = bad ? "bad" : tally.beyond > 0 ? "changed" : "good";
    return std::string("<p class='") + look + "'>" + report::html::escaped(tally_text(tally)) + "</p>\n";
}

std::string rawlogs_html(const char* what, const std::vector<std::string>& ids) {
    if (ids.empty()) return "";
    std::string list;
    for (const std::string& id : ids) list += (list.empty() ? "" : ", ") + id;
    return report::html::paragraph(what + std::string(": ") + list);
}

/// Lists the two runs and the differences of their setup.
std::string runs_html(const Comparison& comparison, const NamedRuns& runs) {
    std::string rows =
        report::html::row({{"folder"}, {runs.name_before}, {runs.name_after}}) +
        report::html::row({{"program"}, {comparison.program_before}, {comparison.program_after}});
    for (const SettingChange& setting : comparison.settings) {
        const bool everywhere = setting.rawlogs == comparison.ids.size();
        const std::string where = everywhere ? "" : ", in " + count_text(setting.rawlogs, "rawlog");
        rows += report::html::row({{setting.key + where}, {setting.before}, {setting.after}}, setting.key);
    }
    std::string note;
    if (comparison.settings.empty()) note = report::html::paragraph("Both have the same settings.");
    if (comparison.other_setup && comparison.settings.empty() &&
        comparison.program_before == comparison.program_after)
        note = report::html::paragraph(
            "Both have the same settings and version, but the program is another file.");
    return "<div class='runs'>" + report::html::table({{""}, {"A"}, {"B"}}, rows) + "</div>" + note +
           rawlogs_html("Only in A", comparison.only_before) +
           rawlogs_html("Only in B", comparison.only_after) +
           rawlogs_html("Not the same recording in A and B", comparison.other_rawlog);
}

}  // namespace

std::string compare_html(const Comparison& comparison, const NamedRuns& runs) {
    const Json data = {{"ids", comparison.ids},
                       {"changes", changes_json(comparison)},
                       {"drives", drives_json(comparison, runs)},
                       {"colours",
                        {{"a", report::palette::run_a.css()},
                         {"b", report::palette::run_b.css()},
                         {"truth", report::palette::run_truth.css()}}}};
    const std::string body =
        summary_html(comparison) + runs_html(comparison, runs) +
        "<noscript><p class='bad'>This page needs JavaScript.</p></noscript>\n"
        "<div id='overview'><div id='glance'></div><div id='thumbs'></div></div>\n<div id='changes'></div>\n"
        "<div id='choice'></div>\n<div id='drive'></div>\n";
    return page("Comparison of two runs", body, data.dump(-1, ' ', false, Json::error_handler_t::replace),
                compare_assets);
}

}  // namespace flownav::regress
