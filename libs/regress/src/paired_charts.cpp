#include "flownav/regress/paired_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flownav/math/units.h"

namespace flownav::regress {

namespace {

/// Rows that have a value.
enum class Rows {
    All,
    EndsOfCycles,
    Filled,  ///< those whose cell is not empty
};

struct Quantity {
    const char* column;
    const char* title;
    const char* unit;
    const char* note;
    double factor;
    double least_span;
    int decimals;
    Rows rows;
};

constexpr auto every_field = "Every field; positive: to the left.";
constexpr auto every_cycle = "At the end of each cycle.";
constexpr auto every_scan = "Of each contact scan.";

constexpr Quantity quantities[] = {
    {"omega_radps", "Turn rate", "deg/s", every_field, deg(1.0), 1.0, 3, Rows::All},
    {"v_mps", "Forward speed", "m/s", every_cycle, 1.0, 0.05, 4, Rows::EndsOfCycles},
    {"obstacles", "Obstacle points", "", every_cycle, 1.0, 10.0, 0, Rows::EndsOfCycles},
    {"confident", "Blocks with an unambiguous match", "", every_cycle, 1.0, 10.0, 0, Rows::EndsOfCycles},
    {"inliers", "Blocks that support the turn rate", "", every_cycle, 1.0, 10.0, 0, Rows::EndsOfCycles},
    {"strips_obstacle", "Contacts", "strips", every_scan, 1.0, 5.0, 0, Rows::Filled},
    {"strips_free", "Strips with confirmed floor", "strips", every_scan, 1.0, 5.0, 0, Rows::Filled},
};

constexpr double same_time_s = 1e-6;

/// Merges two rising lists of times; each time has its row in both lists, or `none`.
struct MergedTimes {
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<double> t;
    std::vector<std::size_t> row_a, row_b;
};

MergedTimes merged(const std::vector<double>& a, const std::vector<double>& b) {
    MergedTimes times;
    for (std::size_t i = 0, k = 0; i < a.size() || k < b.size();) {
        const double t_a = i < a.size() ? a[i] : HUGE_VAL;
        const double t_b = k < b.size() ? b[k] : HUGE_VAL;
        const double t = std::min(t_a, t_b);
        times.t.push_back(t);
        times.row_a.push_back(t_a - t < same_time_s ? i++ : MergedTimes::none);
        times.row_b.push_back(t_b - t < same_time_s ? k++ : MergedTimes::none);
    }
    return times;
}

/// True for the last row of a cycle.
bool ends_cycle(const Columns& run, std::size_t row) {
    const std::vector<double>& image = run.at("image_of_cycle");
    return image[row] > 0.0 && (row + 1 == image.size() || image[row + 1] <= image[row]);
}

double value_at(const Columns& run, const Quantity& quantity, std::size_t row) {
    if (row == MergedTimes::none) return report::ReportSeries::none;
    if (quantity.rows == Rows::EndsOfCycles && !ends_cycle(run, row)) return report::ReportSeries::none;
    const double value = run.at(quantity.column)[row];
    if (quantity.rows == Rows::Filled && std::isnan(value)) return report::ReportSeries::none;
    return std::isfinite(value) ? value * quantity.factor : report::ReportSeries::gap;
}

/// B - A at every time at which one of them has a value. With `holds`, a value is held until the next one.
std::vector<double> differences(const std::vector<double>& a, const std::vector<double>& b, bool holds) {
    std::vector<double> values;
    double last_a = report::ReportSeries::none;
    double last_b = report::ReportSeries::none;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!holds || a[i] != report::ReportSeries::none) last_a = a[i];
        if (!holds || b[i] != report::ReportSeries::none) last_b = b[i];
        const bool news = std::isfinite(a[i]) || std::isfinite(b[i]);
        const bool known = std::isfinite(last_a) && std::isfinite(last_b);
        values.push_back(news && known ? last_b - last_a : report::ReportSeries::none);
    }
    return values;
}

report::ReportChart chart_of(const Quantity& quantity, const Columns& before, const Columns& after,
                             const MergedTimes& times) {
    report::ReportChart chart;
    chart.id = quantity.column;
    chart.title = quantity.title;
    chart.unit = quantity.unit;
    chart.note = quantity.note;
    chart.decimals = quantity.decimals;
    chart.least_span = quantity.least_span;
    chart.from_zero = quantity.rows != Rows::All;
    chart.series.resize(3);
    std::vector<double>& a = chart.series[0].values;
    std::vector<double>& b = chart.series[1].values;
    for (std::size_t i = 0; i < times.t.size(); ++i) {
        chart.t_s.push_back(times.t[i] - times.t.front());
        a.push_back(value_at(before, quantity, times.row_a[i]));
        b.push_back(value_at(after, quantity, times.row_b[i]));
    }
    chart.series[2].values = differences(a, b, quantity.rows != Rows::All);
    return chart;
}

bool has(const Columns& run, const char* column) {
    return run.count("timestamp") == 1 && run.count("image_of_cycle") == 1 && run.count(column) == 1;
}

}  // namespace

std::vector<report::ReportChart> paired_charts(const Columns& before, const Columns& after) {
    std::vector<report::ReportChart> charts;
    for (const Quantity& quantity : quantities) {
        if (!has(before, quantity.column) || !has(after, quantity.column)) continue;
        const MergedTimes times = merged(before.at("timestamp"), after.at("timestamp"));
        charts.push_back(chart_of(quantity, before, after, times));
    }
    return charts;
}

}  // namespace flownav::regress
