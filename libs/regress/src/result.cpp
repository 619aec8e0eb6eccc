#include "flownav/regress/result.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "flownav/io/output_file.h"

namespace flownav::regress {

namespace {

using Json = nlohmann::ordered_json;

/// Numbers that are no figures: they locate an event or repeat other figures.
const std::set<std::string> no_figures = {
    "input", "config", "timing", "read.observations", "written.result_rawlog", "drive.start_s"};

void flatten(const Json& part, const std::string& name, Figures& figures) {
    if (no_figures.count(name) != 0) return;
    if (part.is_object()) {
        for (const auto& [key, value] : part.items())
            flatten(value, name.empty() ? key : name + '.' + key, figures);
    } else if (part.is_number()) {
        figures[name] = part.get<double>();
    } else if (part.is_null()) {
        figures[name] = std::nullopt;
    }
}

/// Empty for a missing file or invalid JSON.
std::optional<Json> read_json(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return std::nullopt;
    Json json = Json::parse(stream, nullptr, false);
    if (!json.is_object()) return std::nullopt;
    return json;
}

std::string text_of(const Json& json) {
    // Bytes of messages that are not UTF-8 are replaced.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json json_of(const Figures& figures) {
    Json json = Json::object();
    for (const auto& [name, value] : figures) json[name] = Json::parse(exact_text(value));
    return json;
}

}  // namespace

std::string exact_text(const std::optional<double>& value) {
    constexpr double all_whole_numbers = 9007199254740992.0;  // 2^53: smaller whole numbers are exact
    if (!value) return "null";
    if (*value == std::trunc(*value) && std::abs(*value) < all_whole_numbers)
        return std::to_string(static_cast<long long>(*value));
    return Json(*value).dump();
}

std::string result_text(const Result& result) {
    Json json = {
        {"id", result.id},           {"key", result.key},     {"rawlog_sha256", result.rawlog_sha256},
        {"program", result.program}, {"setup", result.setup}, {"settings", result.ini},
        {"status", result.status}};
    if (!result.reason.empty()) json["reason"] = result.reason;
    if (!result.messages.empty()) json["messages"] = result.messages;
    json["figures"] = json_of(result.figures);
    return text_of(json);
}

std::optional<Result> read_result(const std::filesystem::path& file) try {
    const auto json = read_json(file);
    if (!json) return std::nullopt;
    Result result;
    result.id = json->at("id");
    result.key = json->at("key");
    result.rawlog_sha256 = json->at("rawlog_sha256");
    result.program = json->at("program");
    result.setup = json->at("setup");
    result.ini = json->at("settings");
    result.status = json->at("status");
    result.reason = json->value("reason", "");
    result.messages = json->value("messages", "");
    flatten(json->at("figures"), "", result.figures);
    return result;
} catch (const Json::exception&) {
    return std::nullopt;
}

std::optional<Figures> read_figures(const std::filesystem::path& summary_file) {
    const auto summary = read_json(summary_file);
    if (!summary) return std::nullopt;
    Figures figures;
    flatten(*summary, "", figures);
    return figures;
}

void part_timing(const std::filesystem::path& folder) {
    auto summary = read_json(folder / "summary.json");
    if (!summary || !summary->contains("timing")) return;
    const Json timing = std::move((*summary)["timing"]);
    summary->erase("timing");
    io::write_file(folder / "timing.json", text_of(timing));
    io::write_file(folder / "summary.json", text_of(*summary));
}

}  // namespace flownav::regress
