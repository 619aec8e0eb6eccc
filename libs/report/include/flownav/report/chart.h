#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "flownav/report/palette.h"

namespace flownav::report {

/// A line of a chart: a value for every time of the chart.
struct ReportSeries {
    static constexpr double none = -HUGE_VAL;  ///< no value here; a line of a `connected` series goes on
    static constexpr double gap = HUGE_VAL;    ///< no value here, and the line is interrupted

    std::string name;
    Colour colour;
    bool dashed = false;
    double width_px = 1.8;
    bool connected = false;  ///< values come less often than once a field
    std::vector<double> values;
};

/// Series over the same times.
struct ReportChart {
    std::string id;
    std::string title;
    std::string quantity;  ///< for the axis
    std::string unit;      ///< empty for counts
    std::string note;      ///< for people
    bool stacked = false;
    bool from_zero = false;
    int decimals = 3;
    double least_span = 0.0;  ///< of the values, so that noise about a constant does not fill the chart
    std::vector<double> t_s;  ///< since the first field
    std::vector<ReportSeries> series;
};

/// At most about `most` times of a chart. Lowest, highest and a gap of each series stay in every stretch, so
/// that neither a spike nor an interruption is lost.
ReportChart thinned(ReportChart chart, std::size_t most);

}  // namespace flownav::report
