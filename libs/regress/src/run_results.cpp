#include "flownav/regress/run_results.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>

#include "flownav/cli/usage_error.h"
#include "flownav/core/version.h"
#include "flownav/regress/store.h"

namespace flownav::regress {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t shown_digits = 8;

RawlogResult result_of(const std::string& id, const fs::path& output, const std::string& sha256) {
    const std::pair<Outcome, fs::path> places[] = {{Outcome::Done, output / "done" / id / result_file},
                                                   {Outcome::Failed, output / "failed" / id / failure_file}};
    for (const auto& [outcome, file] : places) {
        auto result = read_result(file);
        if (!result || (!sha256.empty() && result->rawlog_sha256 != sha256)) continue;
        return {id, outcome, file.parent_path(), std::move(*result)};
    }
    return {id, Outcome::Missing, {}, {}};
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        names.insert(entry.path().filename());
    return names;
}

nlohmann::ordered_json json_of(const RawlogResult& rawlog) {
    nlohmann::ordered_json json = {{"id", rawlog.id}, {"outcome", to_string(rawlog.outcome)}};
    if (rawlog.outcome == Outcome::Missing) return json;
    json["status"] = rawlog.result.status;
    if (!rawlog.result.reason.empty()) json["reason"] = rawlog.result.reason;
    json["settings"] = rawlog.result.ini;
    json["figures"] = nlohmann::ordered_json::object();
    for (const auto& [name, value] : rawlog.result.figures)
        json["figures"][name] = nlohmann::ordered_json::parse(exact_text(value));
    return json;
}

}  // namespace

const char* to_string(Outcome outcome) {
    switch (outcome) {
        case Outcome::Done:
            return "done";
        case Outcome::Failed:
            return "failed";
        case Outcome::Missing:
            break;
    }
    return "missing";
}

RunResults collect(const Manifest& manifest, const fs::path& output) {
    RunResults results;
    for (const ManifestEntry& entry : manifest) results.push_back(result_of(entry.id, output, entry.sha256));
    return results;
}

RunResults collect_all(const fs::path& output) {
    if (!fs::is_directory(output / "done") && !fs::is_directory(output / "failed"))
        throw cli::UsageError(output.string() +
                              ": no results of flownav-regress run there (no folder done or failed)");
    std::set<std::string> ids = names_in(output / "done");
    ids.merge(names_in(output / "failed"));
    RunResults results;
    for (const std::string& id : ids) results.push_back(result_of(id, output, ""));
    return results;
}

std::string mixture_in(const RunResults& results) {
    std::map<std::string, int> counts;
    for (const RawlogResult& rawlog : results)
        if (rawlog.outcome != Outcome::Missing)
            ++counts[rawlog.result.program + " (setup " + rawlog.result.setup.substr(0, shown_digits) + ")"];
    if (counts.size() < 2) return "";
    std::string text = "the results were made by different programs or settings:";
    for (const auto& [program, number] : counts)
        text += " " + std::to_string(number) + " by " + program + ",";
    text.pop_back();
    return text;
}

std::string lines_with(Outcome outcome, const RunResults& results) {
    std::string lines;
    for (std::size_t k = 0; k < results.size(); ++k)
        if (results[k].outcome == outcome) lines += (lines.empty() ? "" : ",") + std::to_string(k);
    return lines;
}

std::size_t count(Outcome outcome, const RunResults& results) {
    return static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(),
                      [outcome](const RawlogResult& rawlog) { return rawlog.outcome == outcome; }));
}

std::string program_of(const RunResults& results) {
    for (const RawlogResult& rawlog : results)
        if (!rawlog.result.program.empty()) return rawlog.result.program;
    return "";
}

std::string merged_json(const RunResults& results) {
    nlohmann::ordered_json json = {{"program", "flownav-regress"},
                                   {"version", version()},
                                   {"replayed_by", program_of(results)},
                                   {"rawlogs", results.size()}};
    for (const Outcome outcome : {Outcome::Done, Outcome::Failed, Outcome::Missing})
        json[to_string(outcome)] = count(outcome, results);
    json["results"] = nlohmann::ordered_json::array();
    for (const RawlogResult& rawlog : results) json["results"].push_back(json_of(rawlog));
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::set<std::string> figure_names(const RunResults& results) {
    std::set<std::string> names;
    for (const RawlogResult& rawlog : results)
        for (const auto& [name, value] : rawlog.result.figures) names.insert(name);
    return names;
}

std::string csv_row(const RawlogResult& rawlog, const std::set<std::string>& names) {
    const bool missing = rawlog.outcome == Outcome::Missing;
    std::string row = rawlog.id + ',' + to_string(rawlog.outcome) + ',' +
                      (missing ? "" : std::to_string(rawlog.result.status));
    for (const std::string& name : names) {
        const auto figure = rawlog.result.figures.find(name);
        row += ',';
        if (figure != rawlog.result.figures.end() && figure->second) row += exact_text(figure->second);
    }
    return row + '\n';
}

std::string csv_head(const std::set<std::string>& names) {
    std::string head = "id,outcome,status";
    for (const std::string& name : names) head += ',' + name;
    return head + '\n';
}

std::string merged_csv(const RunResults& results) {
    const std::set<std::string> names = figure_names(results);
    std::string text = csv_head(names);
    for (const RawlogResult& rawlog : results) text += csv_row(rawlog, names);
    return text;
}

}  // namespace flownav::regress
