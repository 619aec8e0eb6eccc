#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "flownav/report/palette.h"

namespace flownav {

/// One line of a chart. A new piece starts after a gap in the data; a piece of one point is drawn as a dot.
struct ChartSeries {
    std::string name;
    report::Colour colour;
    std::vector<std::vector<Eigen::Vector2d>> pieces;
    bool dashed = false;
    double width_px = 1.8;
};

/// A line chart. Series are drawn in order, the last on top.
struct Chart {
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<ChartSeries> series;
    bool equal_scales = false;              ///< uses the same scale for x and y, as in a plan
    std::optional<Eigen::Vector2d> x_span;  ///< from, to; empty: the range of the data
    bool y_from_zero = false;
    /// Minimum range of y, so that noise about a constant does not fill the chart.
    double least_y_span = 1e-3;
};

/// Returns the chart as an <svg> element with labels and legend, or with a note when there are no data.
std::string svg_chart(const Chart& chart);

/// Returns the chart as a complete picture file, on white.
std::string svg_file(const Chart& chart);

/// Reduces a piece to about `most` points; keeps the minimum and maximum of merged points.
std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& piece, std::size_t most);

}  // namespace flownav
