#include "flownav/replay/annotated_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "flownav/replay/number_text.h"

namespace flownav {

namespace {

constexpr int block_px = 16;
constexpr double narrowest_px = 760.0;
constexpr double widest_px = 1280.0;
constexpr int line_height_px = 24;
constexpr int margin_px = 10;
constexpr double font_scale = 0.5;
constexpr double shortest_arrow_px = 6.0;
const cv::Scalar rim(25, 25, 25);
const cv::Scalar paper(255, 255, 255);
const cv::Scalar ink(30, 30, 30);

struct Style {
    BlockFate fate;
    cv::Scalar colour;  ///< BGR, of the palette of Okabe and Ito
    const char* label;
};

/// In the order they are drawn: what matters most lies on top.
const std::array<Style, 7>& styles() {
    static const std::array<Style, 7> all = {{
        {BlockFate::Sifted, {150, 150, 150}, "ambiguous"},
        {BlockFate::Unjudged, {233, 180, 86}, "unjudged"},
        {BlockFate::Ground, {115, 158, 0}, "ground"},
        {BlockFate::Eliminated, {167, 121, 204}, "eliminated"},
        {BlockFate::Unsupported, {66, 228, 240}, "unsupported"},
        {BlockFate::Moving, {178, 114, 0}, "moving"},
        {BlockFate::Obstacle, {0, 94, 213}, "obstacle"},
    }};
    return all;
}

/// From pixels of the field to pixels of the picture.
struct Scale {
    double x = 1.0;
    double y = 1.0;
};

Scale picture_scale(const Field& field) {
    const double width = field.image.width_px;
    const double zoom =
        width < narrowest_px ? std::ceil(narrowest_px / width) : std::min(1.0, widest_px / width);
    const double stretch = field.camera.fy_px > 0 ? field.camera.fx_px / field.camera.fy_px : 1.0;
    return {zoom, zoom * std::clamp(stretch, 0.5, 2.0)};
}

cv::Point at(const Scale& scale, const Eigen::Vector2d& pixel) {
    // OpenCV resizes about pixel corners.
    return {cvRound((pixel.x() + 0.5) * scale.x - 0.5), cvRound((pixel.y() + 0.5) * scale.y - 0.5)};
}

cv::Mat enlarged(const Field& field, const Scale& scale) {
    const ImageView& view = field.image;
    const cv::Mat grey(view.height_px, view.width_px, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                       static_cast<std::size_t>(view.stride_bytes));
    cv::Mat picture;
    cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
    cv::resize(picture, picture, {}, scale.x, scale.y, scale.x < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
    return picture;
}

bool drawn(const pipeline::BlockRecord& block, BlockFate fate) {
    return block.fate == fate && (block.vector.valid || fate == BlockFate::Sifted);
}

void tint_blocks(cv::Mat& picture, const pipeline::Step& step, const Scale& scale, const Style& style) {
    const Eigen::Vector2d half(block_px / 2.0, block_px / 2.0);
    const bool strong = style.fate == BlockFate::Obstacle || style.fate == BlockFate::Moving ||
                        style.fate == BlockFate::Unsupported;
    for (const auto& block : step.blocks) {
        if (!drawn(block, style.fate) || style.fate == BlockFate::Sifted) continue;
        const Eigen::Vector2d now = block.vector.at_px + block.vector.flow_px;
        const cv::Rect area =
            cv::Rect(at(scale, now - half), at(scale, now + half)) & cv::Rect({0, 0}, picture.size());
        if (area.empty()) continue;
        cv::Mat patch = picture(area);
        const double share = (strong ? 0.45 : 0.2) * (scale.x > 2 ? 0.5 : 1.0);  // enlarged blocks overlap
        cv::addWeighted(patch, 1 - share, cv::Mat(patch.size(), patch.type(), style.colour), share, 0, patch);
        if (strong) cv::rectangle(picture, area, style.colour, 1);
    }
}

/// Drawn with a dark rim, so that it shows on light and dark ground.
void draw_arrow(cv::Mat& picture, const cv::Point& from, const cv::Point& to, const cv::Scalar& colour) {
    const double length_px = cv::norm(to - from);
    if (length_px < shortest_arrow_px) {
        cv::circle(picture, to, 4, rim, cv::FILLED, cv::LINE_AA);
        cv::circle(picture, to, 3, colour, cv::FILLED, cv::LINE_AA);
        return;
    }
    const double head = std::min(0.5, 7.0 / length_px);
    cv::arrowedLine(picture, from, to, rim, 4, cv::LINE_AA, 0, head);
    cv::arrowedLine(picture, from, to, colour, 2, cv::LINE_AA, 0, head);
}

void draw_vectors(cv::Mat& picture, const pipeline::Step& step, const Scale& scale, const Style& style) {
    for (const auto& block : step.blocks) {
        if (!drawn(block, style.fate)) continue;
        const cv::Point from = at(scale, block.vector.at_px);
        if (style.fate == BlockFate::Sifted) {
            cv::circle(picture, from, 2, style.colour, cv::FILLED, cv::LINE_AA);
            continue;
        }
        const cv::Point to = at(scale, block.vector.at_px + block.vector.flow_px);
        draw_arrow(picture, from, to, style.colour);
    }
}

int count_of(const pipeline::Step& step, BlockFate fate) {
    return static_cast<int>(std::count_if(step.blocks.begin(), step.blocks.end(),
                                          [fate](const auto& block) { return drawn(block, fate); }));
}

std::string state_text(const pipeline::Step& step) {
    std::string text = std::string("status ") + to_string(step.status);
    if (step.status == FieldStatus::Ok) {
        text += "    turn " + fixed_text(step.omega_radps * 180.0 / M_PI, 1) + " deg/s";
    }
    if (step.status != FieldStatus::Waiting) {
        text +=
            "    speed " + fixed_text(step.v_mps, 2) + " m/s" + (step.v_measured ? "" : " (carried over)");
    }
    return text + "    image " + std::to_string(step.image_of_cycle) + " of " +
           std::to_string(step.cycle_images);
}

/// One line of text with an optional coloured mark before it; wraps at the right edge.
class Caption {
  public:
    explicit Caption(int width_px) : width_px_(width_px), band_(line_height_px, width_px, CV_8UC3, paper) {}

    void add(const std::string& text, const cv::Scalar* mark = nullptr) {
        const int mark_px = mark != nullptr ? 20 : 0;
        const int text_px = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, font_scale, 1, nullptr).width;
        if (x_ > margin_px && x_ + mark_px + text_px + margin_px > width_px_) new_line();
        const int baseline = band_.rows - 8;
        if (mark != nullptr) cv::rectangle(band_, {x_, baseline - 11, 14, 12}, *mark, cv::FILLED);
        cv::putText(band_, text, {x_ + mark_px, baseline}, cv::FONT_HERSHEY_SIMPLEX, font_scale, ink, 1,
                    cv::LINE_AA);
        x_ += mark_px + text_px + 22;
    }

    void new_line() {
        cv::copyMakeBorder(band_, band_, 0, line_height_px, 0, 0, cv::BORDER_CONSTANT, paper);
        x_ = margin_px;
    }

    const cv::Mat& band() const { return band_; }

  private:
    int width_px_;
    int x_ = margin_px;
    cv::Mat band_;
};

}  // namespace

cv::Mat annotated_field(const Field& field, const pipeline::Step& step) {
    const Scale scale = picture_scale(field);
    cv::Mat picture = enlarged(field, scale);
    for (const Style& style : styles()) tint_blocks(picture, step, scale, style);
    for (const Style& style : styles()) draw_vectors(picture, step, scale, style);
    Caption caption(picture.cols);
    caption.add(state_text(step));
    caption.new_line();
    for (auto style = styles().rbegin(); style != styles().rend(); ++style) {
        caption.add(std::string(style->label) + ' ' + std::to_string(count_of(step, style->fate)),
                    &style->colour);
    }
    cv::Mat result;
    cv::vconcat(picture, caption.band(), result);
    return result;
}

}  // namespace flownav
