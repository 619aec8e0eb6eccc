#include "block_panel.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/cli/number_text.h"
#include "flownav/math/units.h"
#include "flownav/report/label_style.h"
#include "ink.h"

namespace flownav::view {

namespace {

constexpr int margin_px = 8;
constexpr int axis_px = 18;
constexpr int caption_px = 6 * 16 + 6;
constexpr double small = 0.4;
constexpr int small_line_px = 16;

std::string pair_text(const Eigen::Vector2d& v, int decimals) {
    return '(' + cli::fixed_text(v.x(), decimals) + ", " + cli::fixed_text(v.y(), decimals) + ')';
}

std::string measured_in(const pipeline::BlockRecord& block) {
    if (block.image_of_cycle == 0) return "none";
    const std::string image = "image " + std::to_string(block.image_of_cycle);
    return block.fresh ? image + ", this one" : image + ", kept since";
}

struct HeatScale {
    double low = 0.0;
    double high = 1.0;
};

HeatScale scale_of(const SadWindow& window) {
    HeatScale scale{65535.0, 0.0};
    for (const std::uint16_t cost : window.surface) {
        if (cost == flow::no_cost) continue;
        scale.low = std::min<double>(scale.low, cost);
        scale.high = std::max<double>(scale.high, cost);
    }
    if (scale.high <= scale.low) scale.high = scale.low + 1.0;
    return scale;
}

/// Draws one pixel per offset: dark is a good match, bright a bad one, hatched grey outside the image.
cv::Mat heat_map(const SadWindow& window) {
    const HeatScale scale = scale_of(window);
    cv::Mat heat(flow::search_px, flow::search_px, CV_8UC1);
    cv::Mat outside(flow::search_px, flow::search_px, CV_8UC1, cv::Scalar(0));
    for (int row = 0; row < flow::search_px; ++row) {
        for (int column = 0; column < flow::search_px; ++column) {
            const std::uint16_t cost = window.surface.at(std::size_t{flow::search_px} * row + column);
            if (cost == flow::no_cost) outside.at<std::uint8_t>(row, column) = 255;
            const double share = (std::min<double>(cost, scale.high) - scale.low) / (scale.high - scale.low);
            heat.at<std::uint8_t>(row, column) = cv::saturate_cast<std::uint8_t>(255.0 * share);
        }
    }
    cv::Mat coloured;
    cv::applyColorMap(heat, coloured, cv::COLORMAP_CIVIDIS);
    coloured.setTo(faint, outside);
    return coloured;
}

void mark_cell(cv::Mat& panel, const cv::Rect& area, int cell_px, int mu, int nu, const cv::Scalar& colour) {
    const cv::Rect cell(area.x + (mu - flow::search_min) * cell_px,
                        area.y + (nu - flow::search_min) * cell_px, cell_px, cell_px);
    cv::rectangle(panel, cell, ink, 3);
    cv::rectangle(panel, cell, colour, 2);
}

std::string per_pixel(std::uint16_t cost) {
    constexpr double pixels = 1.0 * flow::block_px * flow::block_px;
    return std::to_string(cost) + ", " + cli::fixed_text(cost / pixels, 1) + " a pixel";
}

void draw_axes(cv::Mat& panel, const cv::Rect& area, int cell_px) {
    for (const int offset : {flow::search_min, 0, flow::search_max}) {
        const int shift = (offset - flow::search_min) * cell_px + cell_px / 2;
        const std::string text = std::to_string(offset);
        write_text(panel, {area.x + shift - text_width(text, small) / 2, area.y + area.height + 13}, text,
                   grey, small);
        write_text(panel, {area.x - 4 - text_width(text, small), area.y + shift + 4}, text, grey, small);
    }
    write_text(panel, {area.x + area.width - 70, area.y - 5}, "mu, nu in px", grey, small);
}

void draw_surface(cv::Mat& panel, const SadWindow& window, const cv::Rect& room) {
    const int cell_px = std::min((room.width - 2 * axis_px) / flow::search_px,
                                 (room.height - 2 * axis_px - caption_px) / flow::search_px);
    if (cell_px < 3) return;
    const cv::Rect area(room.x + axis_px + 4, room.y + axis_px, cell_px * flow::search_px,
                        cell_px * flow::search_px);
    write_text(panel, {room.x + axis_px, room.y + 12}, "SAD surface", ink, text_scale);
    cv::Mat heat;
    cv::resize(heat_map(window), heat, area.size(), 0, 0, cv::INTER_NEAREST);
    heat.copyTo(panel(area));
    draw_axes(panel, area, cell_px);
    if (window.match.second != flow::no_cost)
        mark_cell(panel, area, cell_px, window.second.x(), window.second.y(), orange);
    mark_cell(panel, area, cell_px, window.match.mu, window.match.nu, paper);
    int y = area.y + area.height + axis_px + 12;
    const auto line = [&](const std::string& text) {
        write_text(panel, {room.x + 4, y}, fitted(text, room.width - 4, small), ink, small);
        y += small_line_px;
    };
    line("minimum (white)  " + per_pixel(window.match.minimum));
    line("second (orange)  " +
         (window.match.second == flow::no_cost ? "none" : per_pixel(window.match.second)));
    const auto at = [](int u, int v) { return '(' + std::to_string(u) + ", " + std::to_string(v) + ") px"; };
    line("window at " + at(window.bias_px.x(), window.bias_px.y()));
    line("minimum in it at " + at(window.match.mu, window.match.nu));
    line("dark: good match; grey: outside image");
    line("exposure: gain " + cli::fixed_text(window.brightness.gain, 3) + ", offset " +
         cli::fixed_text(window.brightness.offset, 1));
}

}  // namespace

std::vector<std::string> block_lines(const Frame& frame, std::size_t index) {
    const pipeline::BlockRecord& block = frame.step.blocks[index];
    const FlowVector& vector = block.vector;
    return {
        "block " + std::to_string(index) + ": " + to_string(block.label),
        "centre " + pair_text(vector.at_px, 1) + " px in the reference",
        "flow " + pair_text(vector.flow_px, 2) + " px",
        "sigma " + pair_text(vector.sigma_px, 2) + " px",
        "predicted " + pair_text(block.predicted_px, 2) + " px",
        "confidence " + cli::fixed_text(vector.confidence, 3) + (vector.valid ? "" : ", not valid"),
        "measured in " + measured_in(block),
        "ground window " + std::string(block.in_ground_window ? "yes" : "no"),
        "excess (13) " + cli::fixed_text(block.excess_px, 2) + " px",
        "omega (4) " + cli::fixed_text(deg(block.omega_rad), 3) + " deg",
        "ray at " + pair_text(block.ray.at, 4),
        "ray flow " + pair_text(block.ray.flow, 5),
        "ray sigma " + pair_text(block.ray.sigma, 5),
    };
}

cv::Mat block_panel(const Frame& frame, std::optional<std::size_t> block,
                    const std::optional<SadWindow>& window, const cv::Size& size) {
    cv::Mat panel(size, CV_8UC3, paper);
    if (!block) {
        write_text(panel, {margin_px, 20}, fitted("Point at a block to see its numbers.", size.width - 16),
                   grey);
        return panel;
    }
    const std::vector<std::string> lines = block_lines(frame, *block);
    int text_px = 0;
    for (const std::string& line : lines) text_px = std::max(text_px, text_width(line, small));
    text_px = std::min(text_px + margin_px, size.width * 55 / 100);
    const report::LabelStyle* style = report::style_of(frame.step.blocks[*block].label);
    int y = 16;
    for (const std::string& line : lines) {
        const bool title = y == 16;
        if (title && style != nullptr)
            cv::rectangle(panel, {margin_px, 6, 11, 11}, style->colour, cv::FILLED);
        write_text(panel, {margin_px + (title ? 16 : 0), y}, fitted(line, text_px, small), ink, small);
        y += small_line_px + 1;
    }
    const cv::Rect room(margin_px + text_px, 2, size.width - text_px - 2 * margin_px, size.height - 4);
    if (window) {
        draw_surface(panel, *window, room);
    } else {
        write_text(panel, {room.x + 4, 16}, fitted("no SAD surface here", room.width), grey, small);
    }
    return panel;
}

}  // namespace flownav::view
