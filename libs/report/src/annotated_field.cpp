#include "flownav/report/annotated_field.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "flownav/cli/number_text.h"
#include "flownav/core/strip_counts.h"
#include "flownav/math/units.h"
#include "flownav/report/cause_style.h"
#include "flownav/report/contact_drawing.h"
#include "flownav/report/field_drawing.h"
#include "flownav/report/palette.h"

namespace flownav::report {

namespace {

constexpr double narrowest_px = 760.0;
constexpr double widest_px = 1280.0;
constexpr int line_height_px = 24;
constexpr int margin_px = 10;
constexpr double font_scale = 0.5;

FieldScale picture_scale(const Field& field) {
    const double width = field.image.width_px;
    const double zoom =
        width < narrowest_px ? std::ceil(narrowest_px / width) : std::min(1.0, widest_px / width);
    return {zoom, zoom * pixel_aspect(field)};
}

int count_of(const pipeline::Step& step, BlockLabel label) {
    return static_cast<int>(std::count_if(step.blocks.begin(), step.blocks.end(),
                                          [label](const auto& block) { return is_drawn(block, label); }));
}

std::string state_text(const pipeline::Step& step) {
    std::string text = std::string("status ") + to_string(step.status);
    if (step.status == FieldStatus::Ok) {
        text += "    turn " + cli::fixed_text(deg(step.omega_radps), 1) + " deg/s";
    }
    if (step.status != FieldStatus::Waiting) {
        text += "    speed " + cli::fixed_text(step.v_mps, 2) + " m/s" +
                (step.v_measured ? "" : " (carried over)");
    }
    return text + "    image " + std::to_string(step.image_of_cycle) + " of " +
           std::to_string(step.cycle_images);
}

/// One line of text with an optional coloured mark before it; wraps at the right edge.
class Caption {
  public:
    explicit Caption(int width_px)
        : width_px_(width_px), band_(line_height_px, width_px, CV_8UC3, cv::Scalar(palette::paper)) {}

    void add(const std::string& text, const Colour* mark = nullptr) {
        const int mark_px = mark != nullptr ? 20 : 0;
        const int text_px = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, font_scale, 1, nullptr).width;
        if (x_ > margin_px && x_ + mark_px + text_px + margin_px > width_px_) new_line();
        const int baseline = band_.rows - 8;
        if (mark != nullptr) cv::rectangle(band_, {x_, baseline - 11, 14, 12}, *mark, cv::FILLED);
        cv::putText(band_, text, {x_ + mark_px, baseline}, cv::FONT_HERSHEY_SIMPLEX, font_scale, palette::ink,
                    1, cv::LINE_AA);
        x_ += mark_px + text_px + 22;
    }

    void new_line() {
        cv::copyMakeBorder(band_, band_, 0, line_height_px, 0, 0, cv::BORDER_CONSTANT, palette::paper);
        x_ = margin_px;
    }

    const cv::Mat& band() const { return band_; }

  private:
    int width_px_;
    int x_ = margin_px;
    cv::Mat band_;
};

void add_labels(Caption& caption, const pipeline::Step& step) {
    for (auto style = label_styles().rbegin(); style != label_styles().rend(); ++style) {
        caption.add(std::string(style->name) + ' ' + std::to_string(count_of(step, style->label)),
                    &style->colour);
    }
}

/// Strips of the contact scan by content.
void add_contacts(Caption& caption, const ContactScan& contacts) {
    const StripCounts counts = counts_of(contacts);
    caption.add(std::string("contact scan ") + to_string(contacts.gate));
    caption.add("floor " + std::to_string(counts.free), &confirmed_floor);
    for (const CauseStyle& style : cause_styles()) {
        if (style.cause == BeamCause::Blocks) continue;
        const int count = counts.by_cause.at(static_cast<std::size_t>(style.cause));
        caption.add(std::string(style.name) + ' ' + std::to_string(count), &style.colour);
    }
    caption.add("unknown " + std::to_string(counts.unknown));
}

}  // namespace

cv::Mat marked_field(const Field& field, const pipeline::Step& step, const ContactScan& contacts,
                     const FieldScale& scale) {
    cv::Mat picture = scaled_field(field, scale);
    const CameraModel camera = camera_in_use(field, step);
    tint_free_floor(picture, contacts, camera, scale);
    for (const LabelStyle& style : label_styles()) tint_blocks(picture, step, scale, style);
    for (const LabelStyle& style : label_styles()) draw_vectors(picture, step, scale, style);
    draw_contacts(picture, contacts, camera, scale);
    return picture;
}

cv::Mat annotated_field(const Field& field, const pipeline::Step& step, const ContactScan& contacts) {
    const cv::Mat picture = marked_field(field, step, contacts, picture_scale(field));
    Caption caption(picture.cols);
    caption.add(state_text(step));
    caption.new_line();
    add_labels(caption, step);
    caption.new_line();
    add_contacts(caption, contacts);
    cv::Mat result;
    cv::vconcat(picture, caption.band(), result);
    return result;
}

}  // namespace flownav::report
