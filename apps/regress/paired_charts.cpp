#include "paired_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flownav::regress {

namespace {

struct Quantity {
    const char* column;
    const char* title;
    const char* unit;
    double factor;
    int decimals;
    double least_span;
    bool of_cycles;  ///< tells something at the end of a cycle only
    const char* note;
};

constexpr Quantity quantities[] = {
    {"omega_radps", "Turn rate", "deg/s", 180.0 / M_PI, 3, 1.0, false, "Every field; positive: to the left."},
    {"v_mps", "Forward speed", "m/s", 1.0, 4, 0.05, true, "At the end of each cycle."},
    {"obstacles", "Obstacle points", "", 1.0, 0, 10.0, true, "At the end of each cycle."},
    {"confident", "Blocks with an unambiguous match", "", 1.0, 0, 10.0, true, "At the end of each cycle."},
    {"inliers", "Blocks that support the turn rate", "", 1.0, 0, 10.0, true, "At the end of each cycle."},
};

constexpr double same_time_s = 1e-6;

/// For every time that is in one of two rising lists: its row in each, or none.
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

/// Whether a row is the last of its cycle.
bool ends_cycle(const Columns& run, std::size_t row) {
    const std::vector<double>& image = run.at("image_of_cycle");
    return image[row] > 0.0 && (row + 1 == image.size() || image[row + 1] <= image[row]);
}

double value_at(const Columns& run, const Quantity& quantity, std::size_t row) {
    if (row == MergedTimes::none) return ReportSeries::none;
    if (quantity.of_cycles && !ends_cycle(run, row)) return ReportSeries::none;
    const double value = run.at(quantity.column)[row];
    return std::isfinite(value) ? value * quantity.factor : ReportSeries::gap;
}

ReportChart chart_of(const Quantity& quantity, const Columns& before, const Columns& after,
                     const MergedTimes& times) {
    ReportChart chart;
    chart.id = quantity.column;
    chart.title = quantity.title;
    chart.unit = quantity.unit;
    chart.note = quantity.note;
    chart.decimals = quantity.decimals;
    chart.least_span = quantity.least_span;
    chart.from_zero = quantity.of_cycles;
    for (const double t : times.t) chart.t_s.push_back(t - times.t.front());
    chart.series.resize(3);
    for (std::size_t i = 0; i < times.t.size(); ++i) {
        const double a = value_at(before, quantity, times.row_a[i]);
        const double b = value_at(after, quantity, times.row_b[i]);
        const bool both = std::isfinite(a) && std::isfinite(b);
        chart.series[0].values.push_back(a);
        chart.series[1].values.push_back(b);
        chart.series[2].values.push_back(both ? b - a : ReportSeries::none);
    }
    return chart;
}

bool has(const Columns& run, const char* column) {
    return run.count("timestamp") == 1 && run.count("image_of_cycle") == 1 && run.count(column) == 1;
}

}  // namespace

std::vector<ReportChart> paired_charts(const Columns& before, const Columns& after) {
    std::vector<ReportChart> charts;
    for (const Quantity& quantity : quantities) {
        if (!has(before, quantity.column) || !has(after, quantity.column)) continue;
        const MergedTimes times = merged(before.at("timestamp"), after.at("timestamp"));
        charts.push_back(chart_of(quantity, before, after, times));
    }
    return charts;
}

}  // namespace flownav::regress
