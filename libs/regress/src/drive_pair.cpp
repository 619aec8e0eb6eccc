#include "flownav/regress/drive_pair.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "flownav/mapping/export.h"
#include "flownav/regress/paired_charts.h"
#include "flownav/regress/paired_maps.h"
#include "flownav/report/data_uri.h"
#include "flownav/report/palette.h"

namespace flownav::regress {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_times = 600;

/// Rounds a value to its shortest text; null for a value that is not finite.
Json rounded(double value, int decimals) {
    if (!std::isfinite(value)) return nullptr;
    const double power = std::pow(10.0, decimals);
    return Json::parse(exact_text(std::round(value * power) / power + 0.0));  // + 0.0 turns -0 into 0
}

Json rounded_all(const std::vector<double>& values, int decimals) {
    Json array = Json::array();
    for (const double value : values)
        array.push_back(value == report::ReportSeries::gap ? Json(false) : rounded(value, decimals));
    return array;
}

Json chart_json(const report::ReportChart& whole) {
    const report::ReportChart chart = report::thinned(whole, most_times);
    return {{"id", chart.id},
            {"title", chart.title},
            {"unit", chart.unit},
            {"note", chart.note},
            {"leastSpan", chart.least_span},
            {"fromZero", chart.from_zero},
            {"decimals", chart.decimals},
            {"t", rounded_all(chart.t_s, 3)},
            {"a", rounded_all(chart.series.at(0).values, chart.decimals)},
            {"b", rounded_all(chart.series.at(1).values, chart.decimals)},
            {"difference", rounded_all(chart.series.at(2).values, chart.decimals)}};
}

/// The trajectory with every k-th pose and the last one.
Json way_json(const std::filesystem::path& file) {
    const Columns columns = read_tum(file);
    if (columns.empty()) return nullptr;
    const std::vector<double>& x = columns.at("x");
    const std::vector<double>& y = columns.at("y");
    const std::size_t step = x.size() / most_times + 1;
    Json way = {{"x", Json::array()}, {"y", Json::array()}};
    for (std::size_t i = 0; i < x.size(); i += step) {
        const std::size_t k = i + step < x.size() ? i : x.size() - 1;
        way["x"].push_back(rounded(x[k], 3));
        way["y"].push_back(rounded(y[k], 3));
    }
    return way;
}

Json ways_json(const RawlogResult& before, const RawlogResult& after) {
    Json ways = {{"a", way_json(before.folder / "trajectory.tum")},
                 {"b", way_json(after.folder / "trajectory.tum")}};
    ways["truth"] = way_json(after.folder / "ground_truth.tum");
    if (ways["truth"].is_null()) ways["truth"] = way_json(before.folder / "ground_truth.tum");
    return ways["a"].is_null() && ways["b"].is_null() ? Json(nullptr) : ways;
}

Json maps_json(const RawlogResult& before, const RawlogResult& after) {
    const auto map_before = read_map(before.folder);
    const auto map_after = read_map(after.folder);
    if (!map_before || !map_after) return nullptr;
    const auto maps = paired(*map_before, *map_after);
    if (!maps) return nullptr;
    const DifferenceColours colours = {report::palette::run_a.bgr(),
                                       report::palette::run_b.bgr(),
                                       {60, 60, 60},
                                       report::palette::paper.bgr(),
                                       cv::Vec3b::all(mapping::MapFiles::unknown)};
    return {{"x", rounded(maps->left_m, 4)},
            {"y", rounded(maps->bottom_m, 4)},
            {"cell", rounded(maps->cell_m, 4)},
            {"columns", maps->before.cols},
            {"rows", maps->before.rows},
            {"onlyA", maps->only_before},
            {"onlyB", maps->only_after},
            {"both", maps->both},
            {"a", report::png_uri(maps->before)},
            {"b", report::png_uri(maps->after)},
            {"difference", report::png_uri(difference_picture(*maps, colours))}};
}

}  // namespace

Json drive_pair(const RawlogResult& before, const RawlogResult& after) {
    Json pair = {{"ways", ways_json(before, after)}, {"maps", maps_json(before, after)}};
    pair["charts"] = Json::array();
    for (const report::ReportChart& chart :
         paired_charts(read_csv(before.folder / "egomotion.csv"), read_csv(after.folder / "egomotion.csv")))
        pair["charts"].push_back(chart_json(chart));
    return pair["ways"].is_null() && pair["maps"].is_null() && pair["charts"].empty() ? Json(nullptr) : pair;
}

}  // namespace flownav::regress
