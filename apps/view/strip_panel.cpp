#include "strip_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>

#include "flownav/cli/number_text.h"
#include "flownav/math/units.h"
#include "ink.h"

namespace flownav::view {

namespace {

constexpr int left_px = 118;
constexpr int right_px = 14;
constexpr int axis_px = 22;
constexpr int band_px = 18;
constexpr int gap_px = 6;

/// One curve: label, colour and value per field, if the field has one.
struct Curve {
    const char* label;
    cv::Scalar colour;
    std::function<std::optional<double>(const evaluation::FieldRow&)> value;
    bool from_zero;
};

const std::array<Curve, 3>& curves() {
    static const std::array<Curve, 3> all = {{{"turn deg/s", vermilion,
                                               [](const evaluation::FieldRow& row) -> std::optional<double> {
                                                   if (row.status != FieldStatus::Ok) return std::nullopt;
                                                   return deg(row.omega_radps);
                                               },
                                               false},
                                              {"speed m/s", blue,
                                               [](const evaluation::FieldRow& row) -> std::optional<double> {
                                                   if (row.status == FieldStatus::Waiting)
                                                       return std::nullopt;
                                                   return row.v_mps;
                                               },
                                               true},
                                              {"obstacle pts", orange,
                                               [](const evaluation::FieldRow& row) -> std::optional<double> {
                                                   if (!row.end_of_cycle) return std::nullopt;
                                                   return row.obstacles;
                                               },
                                               true}}};
    return all;
}

int severity(FieldStatus status) {
    static const std::array<FieldStatus, 5> rising = {FieldStatus::Ok, FieldStatus::Waiting,
                                                      FieldStatus::NoTexture, FieldStatus::Lost,
                                                      FieldStatus::BadField};
    return static_cast<int>(std::find(rising.begin(), rising.end(), status) - rising.begin());
}

double duration_s(const Timeline& timeline) {
    return timeline.rows.empty() ? 1.0 : std::max(0.1, timeline.time_s(timeline.rows.size() - 1));
}

cv::Scalar pale(const cv::Scalar& colour) {
    return colour * 0.4 + paper * 0.6;
}

struct Span {
    double low = 0.0;
    double high = 0.0;
    bool any = false;

    void add(double value) {
        low = any ? std::min(low, value) : value;
        high = any ? std::max(high, value) : value;
        any = true;
    }
};

Span range_of(const Timeline& timeline, const Curve& curve) {
    Span range;
    if (curve.from_zero) range.add(0.0);
    for (const evaluation::FieldRow& row : timeline.rows) {
        if (const auto value = curve.value(row)) range.add(*value);
    }
    if (!range.any) range.add(0.0);
    const double least = curve.from_zero ? 0.1 : 1.0;
    if (range.high - range.low < least) range.high = range.low + least;
    return range;
}

/// Draws each column from its smallest to its largest value, joined to the previous column.
void draw_curve(cv::Mat& panel, const cv::Rect& area, const StripPanelContent& content, const Curve& curve) {
    const Timeline& timeline = content.timeline;
    const Span range = range_of(timeline, curve);
    const auto y_of = [&](double value) {
        return area.y + area.height - 1 -
               cvRound((value - range.low) / (range.high - range.low) * (area.height - 1));
    };
    cv::rectangle(panel, area, faint);
    if (range.low < 0.0 && range.high > 0.0)
        cv::line(panel, {area.x, y_of(0.0)}, {area.x + area.width, y_of(0.0)}, faint);
    cv::Point last(-1, 0);  // left of the panel: starts a new curve
    for (std::size_t i = 0; i < timeline.rows.size(); ++i) {
        const auto value = curve.value(timeline.rows[i]);
        if (!value) {
            if (timeline.rows[i].status != FieldStatus::Ok) last.x = -1;
            continue;
        }
        const cv::Point at(strip_column(timeline, timeline.time_s(i), panel.cols), y_of(*value));
        if (at == last) continue;
        const cv::Scalar colour = i < timeline.current ? curve.colour : pale(curve.colour);
        cv::line(panel, last.x < 0 ? at : last, at, colour, 1, cv::LINE_AA);
        last = at;
    }
    const int decimals = range.high - range.low < 3.0 ? 2 : range.high - range.low < 30.0 ? 1 : 0;
    const auto tick = [&](double value, int y) {
        const std::string text = cli::fixed_text(value, decimals);
        write_text(panel, {left_px - 6 - text_width(text, 0.38), y}, text, grey, 0.38);
    };
    tick(range.high, area.y + 9);
    tick(range.low, area.y + area.height);
    write_text(panel, {4, area.y + area.height / 2 + 4}, curve.label, curve.colour * 0.8, 0.4);
}

void draw_band(cv::Mat& panel, const cv::Rect& area, const Timeline& timeline) {
    std::vector<std::optional<std::size_t>> worst(static_cast<std::size_t>(panel.cols));
    for (std::size_t i = 0; i < timeline.rows.size(); ++i) {
        const bool last = i + 1 == timeline.rows.size();
        const int from = strip_column(timeline, timeline.time_s(i), panel.cols);
        const int to = last ? from : strip_column(timeline, timeline.time_s(i + 1), panel.cols);
        for (int c = std::max(0, from); c <= std::min(to, panel.cols - 1); ++c) {
            auto& shown = worst[static_cast<std::size_t>(c)];
            if (!shown || severity(timeline.rows[i].status) > severity(timeline.rows[*shown].status))
                shown = i;
        }
    }
    for (int c = 0; c < panel.cols; ++c) {
        const auto& shown = worst[static_cast<std::size_t>(c)];
        if (!shown) continue;
        const cv::Scalar colour = report::colour_of(timeline.rows[*shown].status);
        cv::line(panel, {c, area.y}, {c, area.y + area.height - 1},
                 *shown < timeline.current ? colour : pale(colour));
    }
    write_text(panel, {4, area.y + 13}, "status", ink, 0.4);
}

void draw_axis(cv::Mat& panel, const Timeline& timeline, int top, int bottom) {
    const double step_s = round_step(duration_s(timeline) / 10.0);
    const int decimals = step_s < 0.1 ? 2 : step_s < 1.0 ? 1 : 0;
    for (int i = 0; i * step_s <= duration_s(timeline) + 1e-9; ++i) {
        const int column = strip_column(timeline, i * step_s, panel.cols);
        cv::line(panel, {column, top}, {column, bottom + 3}, faint);
        const std::string text = cli::fixed_text(i * step_s, decimals) + (i == 0 ? " s" : "");
        write_text(panel, {std::min(column - 4, panel.cols - text_width(text, 0.4) - 2), bottom + 16}, text,
                   grey, 0.4);
    }
}

void draw_stretch(cv::Mat& panel, const StripPanelContent& content, int bottom) {
    if (!content.stretch) return;
    const auto column = [&](std::size_t index) {
        return strip_column(content.timeline, content.timeline.time_s(index), panel.cols);
    };
    const cv::Rect area = cv::Rect({column(content.stretch->first), 0},
                                   cv::Point(column(content.stretch->second) + 1, bottom)) &
                          cv::Rect({0, 0}, panel.size());
    if (area.empty()) return;
    cv::Mat part = panel(area);
    cv::addWeighted(part, 0.8, cv::Mat(part.size(), part.type(), yellow), 0.2, 0, part);
}

void draw_status_legend(cv::Mat& panel, int top) {
    int x = panel.cols - right_px;
    for (auto status = all_field_statuses.rbegin(); status != all_field_statuses.rend(); ++status) {
        const std::string text = to_string(*status);
        x -= text_width(text, 0.4) + 24;
        cv::rectangle(panel, {x, top + 2, 10, 10}, report::colour_of(*status), cv::FILLED);
        write_text(panel, {x + 14, top + 11}, text, ink, 0.4);
    }
}

}  // namespace

int strip_column(const Timeline& timeline, double time_s, int width_px) {
    const int width = std::max(1, width_px - left_px - right_px);
    return left_px + cvRound(std::clamp(time_s / duration_s(timeline), 0.0, 1.0) * (width - 1));
}

double strip_time_s(const Timeline& timeline, int column, int width_px) {
    const int width = std::max(2, width_px - left_px - right_px);
    return std::clamp((column - left_px) / (width - 1.0), 0.0, 1.0) * duration_s(timeline);
}

cv::Mat strip_panel(const StripPanelContent& content, const cv::Size& size) {
    cv::Mat panel(size, CV_8UC3, paper);
    const Timeline& timeline = content.timeline;
    const int bottom = size.height - axis_px;
    const int top = 18;
    draw_status_legend(panel, 2);
    if (timeline.rows.empty() || bottom < 100) return panel;
    draw_axis(panel, timeline, top, bottom);
    const int height = (bottom - top - band_px) / static_cast<int>(curves().size()) - gap_px;
    int y = top;
    for (const Curve& curve : curves()) {
        draw_curve(panel, {left_px, y, size.width - left_px - right_px, height}, content, curve);
        y += height + gap_px;
    }
    draw_band(panel, {left_px, bottom - band_px, size.width, band_px}, timeline);
    draw_stretch(panel, content, bottom);
    const double now_s = content.index < timeline.rows.size() ? timeline.time_s(content.index) : 0.0;
    const int now = strip_column(timeline, now_s, size.width);
    cv::line(panel, {now, top - 4}, {now, bottom}, ink, 1);
    return panel;
}

}  // namespace flownav::view
