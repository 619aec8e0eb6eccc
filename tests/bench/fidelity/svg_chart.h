#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace flownav {

/// One line of a chart. A new piece starts after a gap in the data; a piece of one point is drawn as a dot.
struct ChartSeries {
    std::string name;
    std::string colour;  ///< as in CSS
    std::vector<std::vector<Eigen::Vector2d>> pieces;
    bool dashed = false;
    double width_px = 1.8;
};

/// A line chart. Series are drawn in their order, the last on top.
struct Chart {
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<ChartSeries> series;
    bool equal_scales = false;              ///< one unit is as long in x as in y, as in a plan
    std::optional<Eigen::Vector2d> x_span;  ///< from, to; without it as far as the data go
    bool y_from_zero = false;
    double least_y_span = 1e-3;  ///< so that noise about a constant does not fill the chart
};

/// The chart as an <svg> element for a web page; labels and legend included. Says so when there are no data.
std::string svg_chart(const Chart& chart);

/// The chart as a picture file of its own, on white.
std::string svg_file(const Chart& chart);

/// At most about `most` points of a piece, keeping lowest and highest of what is merged, so that no spike is
/// lost.
std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& piece, std::size_t most);

/// Text with the characters replaced that mean something in HTML.
std::string html_text(const std::string& text);

}  // namespace flownav
