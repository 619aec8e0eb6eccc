#include "view_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "block_panel.h"
#include "flownav/cli/number_text.h"
#include "flownav/report/field_drawing.h"
#include "ink.h"
#include "map_panel.h"
#include "strip_panel.h"

namespace flownav::view {

namespace {

constexpr int title_px = 24;
constexpr int gap_px = 4;
constexpr double left_share = 0.6;
constexpr double strip_share = 0.24;
constexpr int block_px_high = 330;

/// Text with file, field and time.
std::string where_text(const ViewModel& model) {
    const Timeline& timeline = model.timeline();
    const Frame& frame = model.frame();
    std::string text = model.name() + "    field " + std::to_string(frame.index);
    if (!timeline.rows.empty()) {
        text += " of " + std::to_string(timeline.rows.size()) + "    " +
                cli::fixed_text(frame.step.timestamp_s - timeline.rows.front().timestamp_s, 3) + " s";
    }
    return text + "    time stamp " + cli::time_text(frame.step.timestamp_s);
}

/// Text with the progress of the background, or the end of the file.
std::string news_text(const ViewModel& model, const Look& look) {
    if (!look.note.empty()) return look.note;
    if (model.follows() && !model.timeline().complete) return "following";
    if (!model.timeline().complete)
        return "reading ahead: " + cli::fixed_text(100.0 * model.timeline().progress, 0) + " %";
    return model.timeline().end_text();
}

cv::Mat title_of(const ViewModel& model, const Look& look, const cv::Size& size) {
    cv::Mat title(size, CV_8UC3, faint);
    const std::string where = fitted(where_text(model), size.width - 12);
    write_text(title, {6, 17}, where);
    const int from = 6 + text_width(where) + 30;
    const std::string news = news_text(model, look);
    const bool warns = look.note.empty() && model.timeline().complete;
    if (!news.empty() && from < size.width - 60)
        write_text(title, {from, 17}, fitted(news, size.width - from - 6), warns ? vermilion : blue);
    return title;
}

void put(cv::Mat& picture, const cv::Rect& area, const cv::Mat& panel) {
    panel.copyTo(picture(area));
}

FieldPlace field_place_in(const ViewModel& model, const cv::Size& size) {
    const ViewLayout layout = layout_of(model, size);
    FieldPlace place = field_place(model.frame().field, layout.field.size());
    place.area += layout.field.tl();
    return place;
}

}  // namespace

Look look_for(const config::Config& config) {
    Look look;
    look.ahead_m = std::clamp(config.pipeline.obstacles.range_max_m, 1.0, 100.0);
    return look;
}

ViewLayout layout_of(const cv::Size& size, bool wide) {
    const int width = std::max(size.width, least_width_px);
    const int height = std::max(size.height, least_height_px);
    const int strip = std::max(130, cvRound(strip_share * height));
    const int left = cvRound(left_share * width);
    const int top = title_px + gap_px;
    const int middle = height - strip - gap_px - top;
    const int right = width - left - gap_px;
    const int block = std::clamp(block_px_high, 60, middle / 2);
    ViewLayout layout;
    layout.title = {0, 0, width, title_px};
    layout.strip = {0, height - strip, width, strip};
    if (wide) {
        const int field = middle / 2;
        const int below = top + field + gap_px;
        layout.field = {0, top, width, field};
        layout.map = {0, below, left, middle - field - gap_px};
        layout.block = {left + gap_px, below, right, middle - field - gap_px};
        return layout;
    }
    layout.field = {0, top, left, middle};
    layout.map = {left + gap_px, top, right, middle - block - gap_px};
    layout.block = {left + gap_px, top + middle - block, right, block};
    return layout;
}

ViewLayout layout_of(const ViewModel& model, const cv::Size& size) {
    const Field& field = model.frame().field;
    return layout_of(size, field.image.width_px > 2.0 * report::pixel_aspect(field) * field.image.height_px);
}

cv::Mat view_picture(const ViewModel& model, const Look& look, const cv::Size& size) {
    const ViewLayout layout = layout_of(model, size);
    cv::Mat picture(std::max(size.height, least_height_px), std::max(size.width, least_width_px), CV_8UC3,
                    cv::Scalar::all(200));
    const Frame& frame = model.frame();
    put(picture, layout.title, title_of(model, look, layout.title.size()));
    const FieldPanelContent field{frame, model.config().pipeline.flow, model.hovered_block(),
                                  look.predictions, look.contacts};
    put(picture, layout.field, field_panel(field, layout.field.size()));
    MapPanelContent map{frame, model.timeline(), look.ahead_m};
    map.contacts = look.contacts;
    put(picture, layout.map, map_panel(map, layout.map.size()));
    put(picture, layout.block,
        block_panel(frame, model.hovered_block(), model.hovered_window(), layout.block.size()));
    put(picture, layout.strip,
        strip_panel({model.timeline(), frame.index, model.marked_stretch()}, layout.strip.size()));
    return picture;
}

std::optional<Eigen::Vector2d> field_px_under(const ViewModel& model, const cv::Size& size,
                                              const cv::Point& at) {
    return field_place_in(model, size).field_px(at);
}

cv::Point picture_px_of(const ViewModel& model, const cv::Size& size, const Eigen::Vector2d& field_px) {
    return field_place_in(model, size).panel_px(field_px);
}

}  // namespace flownav::view
