#include <nlohmann/json.hpp>

#include "flownav/regress/figure_rules.h"
#include "flownav/regress/sweep.h"
#include "flownav/report/html.h"
#include "pages.h"

namespace flownav::regress {

namespace {

using Json = nlohmann::ordered_json;

const char* word_for(Better better) {
    switch (better) {
        case Better::Lower:
            return "lower";
        case Better::Higher:
            return "higher";
        case Better::NearerZero:
            return "zero";
        case Better::Unknown:
            break;
    }
    return "";
}

/// Values of one figure: per point a list with a number or null per rawlog. Figures of failed replays are
/// left out, because they cover part of the drive at best.
Json values_of(const std::string& figure, const SweepResults& sweep) {
    Json values = Json::array();
    for (const RunResults& run : sweep.runs) {
        Json row = Json::array();
        for (const RawlogResult& rawlog : run) {
            const auto found = rawlog.result.figures.find(figure);
            const bool known =
                rawlog.outcome == Outcome::Done && found != rawlog.result.figures.end() && found->second;
            row.push_back(Json::parse(exact_text(known ? found->second : std::nullopt)));
        }
        values.push_back(std::move(row));
    }
    return values;
}

bool varies(const Json& values) {
    for (const Json& row : values)
        if (row != values.front()) return true;
    return false;
}

/// Figures with at least two different values.
Json figures_of(const SweepResults& sweep) {
    std::set<std::string> names;
    for (const RunResults& run : sweep.runs) names.merge(figure_names(run));
    Json figures = Json::array();
    for (const std::string& name : names) {
        Json values = values_of(name, sweep);
        if (!varies(values)) continue;
        figures.push_back({{"name", name},
                           {"better", word_for(figure_rule(name, 1.0).better)},
                           {"values", std::move(values)}});
    }
    return figures;
}

Json axes_of(const SweepResults& sweep) {
    Json axes = Json::array();
    for (const SweepAxis& axis : sweep.axes) axes.push_back({{"key", axis.key}, {"values", axis.values}});
    return axes;
}

Json ids_of(const SweepResults& sweep) {
    Json ids = Json::array();
    for (const RawlogResult& rawlog : sweep.runs.front()) ids.push_back(rawlog.id);
    return ids;
}

std::string incomplete_box(const SweepResults& sweep) {
    std::size_t missing = 0;
    std::size_t failed = 0;
    for (const RunResults& run : sweep.runs) {
        missing += count(Outcome::Missing, run);
        failed += count(Outcome::Failed, run);
    }
    if (missing + failed == 0) return "";
    return "<p class='bad'>" + std::to_string(missing) + " replays are missing and " +
           std::to_string(failed) + " failed: they are left out.</p>\n";
}

}  // namespace

std::string sweep_html(const SweepResults& sweep) {
    const Json data = {{"axes", axes_of(sweep)}, {"ids", ids_of(sweep)}, {"figures", figures_of(sweep)}};
    const std::string body =
        report::html::paragraph(std::to_string(sweep.points.size()) + " combinations of " +
                                std::to_string(sweep.axes.size()) + " parameters over " +
                                std::to_string(sweep.runs.front().size()) +
                                " rawlogs. Figures that are the same everywhere are left out.") +
        incomplete_box(sweep) +
        "<noscript><p class='bad'>This page needs JavaScript; sweep.csv holds the same.</p></noscript>\n"
        "<div id='choice'></div>\n<div id='heat'></div>\n<div id='curves'></div>\n<div id='ranking'></div>\n";
    return page("Sweep of parameters", body, data.dump(-1, ' ', false, Json::error_handler_t::replace),
                sweep_assets);
}

}  // namespace flownav::regress
