#include "svg_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flownav/cli/number_text.h"
#include "flownav/report/html.h"

namespace flownav {

namespace {

constexpr double width_px = 760;
constexpr double left_px = 84;
constexpr double right_px = 16;
constexpr double top_px = 44;
constexpr double bottom_px = 48;
constexpr double inner_px = width_px - left_px - right_px;
constexpr double flat_height_px = 230;  ///< height of the plot area of a chart over time
constexpr double lowest_plan_px = 180;  ///< minimum height of the plot area of a plan
constexpr double highest_plan_px = 620;
constexpr std::size_t most_points = 2000;

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    bool empty() const { return low > high; }
    double span() const { return high - low; }
    void pad(double share, double least) {
        const double by = std::max(span() * share, (least - span()) / 2);
        low -= by;
        high += by;
    }
    void widen_to(double wanted) {
        const double by = std::max(0.0, (wanted - span()) / 2);
        low -= by;
        high += by;
    }
};

/// Mapping from data to the page.
struct Frame {
    Range x;
    Range y;
    double height_px = flat_height_px;

    double u(double value) const { return left_px + (value - x.low) / x.span() * inner_px; }
    double v(double value) const { return top_px + (y.high - value) / y.span() * height_px; }
};

/// 1, 2 or 5 times a power of ten, such that the span has about `ticks` steps.
double tick_step(double span, int ticks) {
    const double rough = span / ticks;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    const double digit = rough / power;
    const double nice = digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10;
    return nice * power;
}

std::string text(double x, double y, const std::string& anchor, const std::string& content,
                 const std::string& extra = "") {
    return "<text x='" + cli::fixed_text(x, 1) + "' y='" + cli::fixed_text(y, 1) + "' text-anchor='" +
           anchor + "'" + extra + ">" + report::html::escaped(content) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const std::string& css_class) {
    return "<line class='" + css_class + "' x1='" + cli::fixed_text(x1, 1) + "' y1='" +
           cli::fixed_text(y1, 1) + "' x2='" + cli::fixed_text(x2, 1) + "' y2='" + cli::fixed_text(y2, 1) +
           "'/>\n";
}

std::vector<double> ticks_of(const Range& range, double step) {
    std::vector<double> ticks;
    for (double k = std::ceil(range.low / step - 1e-9); k * step <= range.high + 1e-9 * step; ++k) {
        ticks.push_back(k * step);
    }
    return ticks;
}

std::string tick_label(double value, double step) {
    return cli::fixed_text(value, std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9))));
}

std::string axes(const Chart& chart, const Frame& frame) {
    const double bottom = top_px + frame.height_px;
    const double y_step = tick_step(frame.y.span(), std::max(2, static_cast<int>(frame.height_px / 45)));
    const double x_step = chart.equal_scales ? y_step : tick_step(frame.x.span(), 10);
    std::string svg;
    for (const double x : ticks_of(frame.x, x_step)) {
        svg += line(frame.u(x), top_px, frame.u(x), bottom, "grid");
        svg += text(frame.u(x), bottom + 17, "middle", tick_label(x, x_step));
    }
    for (const double y : ticks_of(frame.y, y_step)) {
        svg += line(left_px, frame.v(y), left_px + inner_px, frame.v(y), "grid");
        svg += text(left_px - 7, frame.v(y) + 4, "end", tick_label(y, y_step));
    }
    svg += line(left_px, bottom, left_px + inner_px, bottom, "axis");
    svg += line(left_px, top_px, left_px, bottom, "axis");
    svg += text(left_px + inner_px / 2, bottom + 38, "middle", chart.x_label);
    const double middle = top_px + frame.height_px / 2;
    svg += text(16, middle, "middle", chart.y_label,
                " transform='rotate(-90 16 " + cli::fixed_text(middle, 1) + ")'");
    return svg;
}

/// Style of a line, as SVG attributes.
std::string stroke(const ChartSeries& series) {
    return " stroke='" + series.colour.css() + "' stroke-width='" + cli::fixed_text(series.width_px, 1) +
           "'" + (series.dashed ? " stroke-dasharray='7 4'" : "");
}

std::string curve(const ChartSeries& series, const Frame& frame, std::size_t most_a_piece) {
    std::string path;
    std::string dots;
    for (const auto& piece : series.pieces) {
        const auto points = thinned(piece, most_a_piece);
        for (std::size_t i = 0; i < points.size(); ++i) {
            path += i == 0 ? "M" : "L";
            path +=
                cli::fixed_text(frame.u(points[i].x()), 1) + ' ' + cli::fixed_text(frame.v(points[i].y()), 1);
        }
        if (points.size() == 1) {
            dots += "<circle cx='" + cli::fixed_text(frame.u(points[0].x()), 1) + "' cy='" +
                    cli::fixed_text(frame.v(points[0].y()), 1) + "' r='1.5' fill='" + series.colour.css() +
                    "'/>\n";
        }
    }
    return "<path class='curve'" + stroke(series) + " d='" + path + "'/>\n" + dots;
}

std::string legend(const Chart& chart) {
    std::string svg;
    double x = left_px;
    for (const ChartSeries& series : chart.series) {
        svg += "<path class='curve'" + stroke(series) + " d='M" + cli::fixed_text(x, 1) + " 33h26'/>\n";
        svg += text(x + 32, 37, "start", series.name);
        x += 32 + 7.2 * static_cast<double>(series.name.size()) + 22;
    }
    return svg;
}

Frame frame_of(const Chart& chart) {
    Frame frame;
    for (const ChartSeries& series : chart.series) {
        for (const auto& piece : series.pieces) {
            for (const Eigen::Vector2d& point : piece) {
                frame.x.include(point.x());
                frame.y.include(point.y());
            }
        }
    }
    if (frame.x.empty()) return frame;
    if (chart.x_span) {
        frame.x.include(chart.x_span->x());
        frame.x.include(chart.x_span->y());
    }
    if (chart.y_from_zero) frame.y.include(0.0);
    frame.y.pad(0.06, chart.least_y_span);
    if (!chart.equal_scales) {
        frame.x.widen_to(1e-3);
        return frame;
    }
    frame.x.pad(0.04, 0.2);
    const double natural_px = inner_px * frame.y.span() / frame.x.span();
    frame.height_px = std::clamp(natural_px, lowest_plan_px, highest_plan_px);
    frame.y.widen_to(frame.x.span() * frame.height_px / inner_px);
    frame.x.widen_to(frame.y.span() * inner_px / frame.height_px);
    return frame;
}

}  // namespace

std::vector<Eigen::Vector2d> thinned(const std::vector<Eigen::Vector2d>& piece, std::size_t most) {
    if (piece.size() <= most || most < 4) return piece;
    const std::size_t bucket = (2 * piece.size() + most - 3) / (most - 2);
    std::vector<Eigen::Vector2d> result = {piece.front()};
    const auto lower = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.y() < b.y(); };
    for (std::size_t from = 1; from + 1 < piece.size(); from += bucket) {
        const auto begin = piece.begin() + static_cast<std::ptrdiff_t>(from);
        const auto end =
            piece.begin() + static_cast<std::ptrdiff_t>(std::min(from + bucket, piece.size() - 1));
        auto [low, high] = std::minmax_element(begin, end, lower);
        if (high < low) std::swap(low, high);
        result.push_back(*low);
        if (low != high) result.push_back(*high);
    }
    result.push_back(piece.back());
    return result;
}

std::string svg_chart(const Chart& chart) {
    const Frame frame = frame_of(chart);
    const double height_px = top_px + frame.height_px + bottom_px;
    std::string svg = "<svg viewBox='0 0 " + cli::fixed_text(width_px, 0) + ' ' +
                      cli::fixed_text(height_px, 0) + "' role='img' aria-label='" +
                      report::html::escaped(chart.title) + "'>\n";
    svg += text(left_px, 17, "start", chart.title, " class='title'");
    if (frame.x.empty()) return svg + text(width_px / 2, height_px / 2, "middle", "no data") + "</svg>\n";
    svg += axes(chart, frame);
    for (const ChartSeries& series : chart.series) {
        const std::size_t share = most_points / std::max<std::size_t>(1, series.pieces.size());
        svg += curve(series, frame, std::max<std::size_t>(4, share));
    }
    return svg + legend(chart) + "</svg>\n";
}

std::string svg_file(const Chart& chart) {
    std::string svg = svg_chart(chart);
    constexpr auto style =
        "<style>text{font:12px sans-serif;fill:#222}.grid{stroke:#ddd}.axis{stroke:#444}.curve{fill:none}"
        "</style>\n<rect width='100%' height='100%' fill='white'/>\n";
    if (svg.find("xmlns") == std::string::npos)
        svg.insert(svg.find("<svg") + 4, " xmlns='http://www.w3.org/2000/svg'");
    return svg.insert(svg.find('>') + 1, style) + '\n';
}

}  // namespace flownav
