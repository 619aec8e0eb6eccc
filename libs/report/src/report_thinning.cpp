#include <algorithm>
#include <optional>

#include "flownav/report/chart.h"

namespace flownav::report {

namespace {

/// Rows of a stretch that must stay: lowest, highest and the first gap of every series.
void keep_extremes(const ReportChart& chart, std::size_t from, std::size_t to, std::vector<char>& keep) {
    for (const ReportSeries& series : chart.series) {
        std::optional<std::size_t> low, high, gap;
        for (std::size_t i = from; i < to; ++i) {
            const double value = series.values[i];
            if (value == ReportSeries::none) continue;
            if (value == ReportSeries::gap) {
                gap = gap.value_or(i);
                continue;
            }
            if (!low || value < series.values[*low]) low = i;
            if (!high || value > series.values[*high]) high = i;
        }
        for (const auto& row : {low, high, gap})
            if (row) keep[*row] = 1;
    }
}

template <typename T>
void pick(std::vector<T>& values, const std::vector<char>& keep) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (keep[i] != 0) values[kept++] = values[i];
    values.resize(kept);
}

}  // namespace

ReportChart thinned(ReportChart chart, std::size_t most) {
    const std::size_t rows = chart.t_s.size();
    if (rows <= most || chart.series.empty()) return chart;
    const std::size_t a_stretch = 3 * chart.series.size();
    const std::size_t stretches = std::max<std::size_t>(1, most / a_stretch);
    std::vector<char> keep(rows, 0);
    keep.front() = keep.back() = 1;
    for (std::size_t i = 0; i < stretches; ++i)
        keep_extremes(chart, i * rows / stretches, (i + 1) * rows / stretches, keep);
    pick(chart.t_s, keep);
    for (ReportSeries& series : chart.series) pick(series.values, keep);
    return chart;
}

}  // namespace flownav::report
