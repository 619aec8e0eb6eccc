#include <fstream>
#include <nlohmann/json.hpp>

#include "flownav/cli/usage_error.h"
#include "flownav/regress/expectation.h"

namespace flownav::regress {

namespace {

using Json = nlohmann::ordered_json;

constexpr int format = 1;

Json json_of(const ExpectedFigure& figure) {
    Json json;
    json["value"] = Json::parse(exact_text(figure.value));
    json[figure.tolerance.relative ? "relative" : "absolute"] =
        Json::parse(exact_text(figure.tolerance.value));
    return json;
}

Json json_of(const ExpectedRawlog& rawlog) {
    Json figures = Json::object();
    for (const auto& [name, figure] : rawlog.figures) figures[name] = json_of(figure);
    return {{"status", rawlog.status}, {"figures", std::move(figures)}};
}

ExpectedFigure figure_of(const Json& json) {
    ExpectedFigure figure;
    const Json& value = json.at("value");
    if (!value.is_null()) figure.value = value.get<double>();
    figure.tolerance.relative = json.contains("relative");
    if (figure.tolerance.relative == json.contains("absolute"))
        throw cli::UsageError("needs either \"absolute\" or \"relative\", the tolerance");
    figure.tolerance.value = json.at(figure.tolerance.relative ? "relative" : "absolute").get<double>();
    if (!(figure.tolerance.value >= 0.0)) throw cli::UsageError("its tolerance must be a number from 0 on");
    return figure;
}

ExpectedRawlog rawlog_of(const Json& json, const std::string& id) {
    ExpectedRawlog rawlog;
    rawlog.status = json.at("status");
    for (const auto& [name, figure] : json.at("figures").items()) {
        try {
            rawlog.figures[name] = figure_of(figure);
        } catch (const std::exception& error) {
            throw cli::UsageError(id + ", " + name + ": " + error.what());
        }
    }
    return rawlog;
}

Expectation expectation_of(const Json& json) {
    const int written_format = json.at("format");
    if (written_format != format)
        throw cli::UsageError("its format is " + std::to_string(written_format) +
                              ", this program reads format " + std::to_string(format));
    Expectation expectation;
    expectation.replayed_by = json.at("replayed_by");
    for (const auto& [id, rawlog] : json.at("rawlogs").items())
        expectation.rawlogs[id] = rawlog_of(rawlog, id);
    return expectation;
}

}  // namespace

Expectation read_expectation(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        throw cli::UsageError("expectation " + file.string() +
                              ": cannot be read; flownav-regress accept writes one");
    try {
        return expectation_of(Json::parse(stream));
    } catch (const std::exception& error) {
        throw cli::UsageError("expectation " + file.string() + ": " + error.what());
    }
}

std::string expectation_text(const Expectation& expectation) {
    Json rawlogs = Json::object();
    for (const auto& [id, rawlog] : expectation.rawlogs) rawlogs[id] = json_of(rawlog);
    const Json head = {{"format", format}, {"replayed_by", expectation.replayed_by}};
    // One line per figure, because the file is read and edited by hand.
    std::string text = "{\n  \"format\": " + head["format"].dump() +
                       ",\n  \"replayed_by\": " + head["replayed_by"].dump() + ",\n  \"rawlogs\": {";
    const char* next_rawlog = "\n";
    for (const auto& [id, rawlog] : rawlogs.items()) {
        text += next_rawlog + ("    " + Json(id).dump()) +
                ": {\n      \"status\": " + rawlog["status"].dump() + ",\n      \"figures\": {";
        const char* next_figure = "\n";
        for (const auto& [name, figure] : rawlog["figures"].items()) {
            text += next_figure + ("        " + Json(name).dump()) + ": " + figure.dump();
            next_figure = ",\n";
        }
        text += "\n      }\n    }";
        next_rawlog = ",\n";
    }
    return text + "\n  }\n}\n";
}

}  // namespace flownav::regress
