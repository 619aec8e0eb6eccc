#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "flownav/replay/drive.h"
#include "flownav/replay/fate_style.h"

namespace flownav {

/// A line of a chart: a value for every time of the chart.
struct ReportSeries {
    static constexpr double none = -HUGE_VAL;  ///< no value here; a line of a `connected` series goes on
    static constexpr double gap = HUGE_VAL;    ///< no value here, and the line is interrupted

    std::string name;
    std::string colour;  ///< as in CSS
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

/// The ways of the robot over the same times, each from the identity on; not a number where not known.
struct ReportTrack {
    ReportSeries look;
    std::vector<Pose2> poses;
};

/// Charts over time: turn rate, forward speed, heading, distance from the truth, blocks by fate, counts.
std::vector<ReportChart> report_charts(const Drive& drive);

/// Flow, odometry and truth, as far as there are any; one pose a field.
std::vector<ReportTrack> report_tracks(const Drive& drive);

/// At most about `most` times of a chart. Lowest, highest and a gap of each series stay in every stretch, so
/// that neither a spike nor an interruption is lost.
ReportChart thinned(ReportChart chart, std::size_t most);

/// The colour of a status, as in CSS.
const char* colour_of(FieldStatus status);

/// The colour of a fate, as in CSS.
std::string css_colour(const FateStyle& style);

}  // namespace flownav
