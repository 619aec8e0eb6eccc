#include "field_panel.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/cli/number_text.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/core/strip_counts.h"
#include "flownav/flow/kernel.h"
#include "flownav/math/units.h"
#include "flownav/report/cause_style.h"
#include "flownav/report/contact_drawing.h"
#include "flownav/report/field_drawing.h"
#include "focus_exclusion.h"
#include "ink.h"

namespace flownav::view {

namespace {

constexpr int margin_px = 8;
constexpr int cone_cell_px = 4;
const cv::Scalar cone_colour(200, 0, 120);

/// Height of the legend; a wide panel needs fewer lines.
int legend_px(int width_px) {
    return (width_px > 1000 ? 5 : 7) * line_px + 4;
}

void draw_ground_window(cv::Mat& picture, const CameraModel& camera, const report::FieldScale& scale) {
    // The limits of in_ground_window().
    const cv::Point top_left = scale.at({camera.width_px / 6.0, camera.height_px * 2.0 / 3.0});
    const cv::Point bottom_right = scale.at({camera.width_px * 5.0 / 6.0, camera.height_px - 1.0});
    const cv::Point top_right(bottom_right.x, top_left.y);
    const cv::Point bottom_left(top_left.x, bottom_right.y);
    dashed_line(picture, top_left, top_right, sky_blue);
    dashed_line(picture, top_left, bottom_left, sky_blue);
    dashed_line(picture, top_right, bottom_right, sky_blue);
}

void draw_focus_exclusion(cv::Mat& picture, const Frame& frame, double focus_exclusion) {
    const RayMapper mapper(report::camera_in_use(frame.field, frame.step));
    cv::Mat mask = focus_exclusion_mask(mapper, focus_exclusion, cone_cell_px);
    cv::resize(mask, mask, picture.size(), 0, 0, cv::INTER_LINEAR);
    mask = mask > 127;
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(mask, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    cv::polylines(picture, outlines, true, cone_colour, 1, cv::LINE_AA);
}

/// Draws a small cross at the predicted end of each vector.
void draw_predictions(cv::Mat& picture, const pipeline::Step& step, const report::FieldScale& scale) {
    for (const auto& block : step.blocks) {
        if (step.image_of_cycle == 0 || block.label == BlockLabel::Unplaced) continue;
        const cv::Point from = scale.at(block.vector.at_px);
        const cv::Point to = scale.at(block.vector.at_px + block.predicted_px);
        if (block.label != BlockLabel::Sifted) cv::line(picture, from, to, paper, 1, cv::LINE_AA);
        cv::drawMarker(picture, to, paper, cv::MARKER_TILTED_CROSS, 5, 1, cv::LINE_AA);
    }
}

void point_out(cv::Mat& picture, const pipeline::BlockRecord& block, const report::FieldScale& scale) {
    const Eigen::Vector2d half(flow::block_px / 2.0, flow::block_px / 2.0);
    const Eigen::Vector2d from = block.vector.at_px;
    const Eigen::Vector2d now = block.vector.valid ? Eigen::Vector2d(from + block.vector.flow_px) : from;
    cv::rectangle(picture, scale.at(from - half), scale.at(from + half), paper, 1, cv::LINE_AA);
    cv::rectangle(picture, scale.at(now - half), scale.at(now + half), ink, 4, cv::LINE_AA);
    cv::rectangle(picture, scale.at(now - half), scale.at(now + half), yellow, 2, cv::LINE_AA);
}

int count_of(const pipeline::Step& step, BlockLabel label) {
    return static_cast<int>(std::count_if(step.blocks.begin(), step.blocks.end(), [label](const auto& block) {
        return report::is_drawn(block, label);
    }));
}

std::string state_text(const Frame& frame) {
    const pipeline::Step& step = frame.step;
    std::string text = std::string("status ") + to_string(step.status);
    if (step.status == FieldStatus::Ok) {
        text += "    turn " + cli::fixed_text(deg(step.omega_radps), 2) + " deg/s    pitch rate " +
                cli::fixed_text(deg(step.pitch_rate_radps), 2) + " deg/s";
    }
    if (step.status != FieldStatus::Waiting) {
        text +=
            "    speed " + cli::fixed_text(step.v_mps, 3) + " m/s" + (step.v_measured ? " (measured)" : "");
    }
    return text + "    image " + std::to_string(step.image_of_cycle) + " of " +
           std::to_string(step.cycle_images);
}

void add_contacts(LegendRow& row, const ContactScan& scan) {
    const StripCounts counts = counts_of(scan);
    row.add("confirmed floor " + std::to_string(counts.free), report::confirmed_floor);
    for (const report::CauseStyle& style : report::cause_styles()) {
        const int count = counts.by_cause.at(static_cast<std::size_t>(style.cause));
        row.add(std::string(style.name) + ' ' + std::to_string(count), style.colour, LegendRow::Mark::Line);
    }
    row.add("scan " + std::string(to_string(scan.gate)), paper);
}

void draw_legend(cv::Mat& panel, const FieldPanelContent& content, int top_px) {
    const pipeline::Step& step = content.frame.step;
    const int width_px = panel.cols - 2 * margin_px;
    write_text(panel, {margin_px, top_px + 15}, fitted(state_text(content.frame), width_px));
    LegendRow row(panel, {margin_px, top_px + line_px + 2, width_px, line_px});
    const auto& styles = report::label_styles();
    for (auto style = styles.rbegin(); style != styles.rend(); ++style) {
        row.add(std::string(style->name) + ' ' + std::to_string(count_of(step, style->label)), style->colour);
    }
    LegendRow more(panel, {margin_px, row.bottom(), width_px, line_px});
    if (content.predictions) more.add("flow predicted for floor (x)", grey, LegendRow::Mark::Line);
    more.add("ground window: tells the speed", sky_blue, LegendRow::Mark::Dash);
    more.add("blind cone, |e| < " + cli::fixed_text(content.flow.focus_exclusion, 2) +
                 ": hardly any flow, no blocks",
             cone_colour, LegendRow::Mark::Line);
    if (!content.contacts) return;
    LegendRow scan(panel, {margin_px, more.bottom(), width_px, line_px});
    add_contacts(scan, content.frame.contacts.scan());
}

/// Draws the field with everything that lies on it.
cv::Mat marked_picture(const FieldPanelContent& content, const report::FieldScale& scale) {
    const Frame& frame = content.frame;
    const CameraModel camera = report::camera_in_use(frame.field, frame.step);
    const ContactScan contacts = content.contacts ? frame.contacts.scan() : ContactScan{};
    cv::Mat picture = report::scaled_field(frame.field, scale);
    report::tint_free_floor(picture, contacts, camera, scale);
    for (const report::LabelStyle& style : report::label_styles())
        report::tint_blocks(picture, frame.step, scale, style);
    if (content.predictions) draw_predictions(picture, frame.step, scale);
    for (const report::LabelStyle& style : report::label_styles())
        report::draw_vectors(picture, frame.step, scale, style);
    report::draw_contacts(picture, contacts, camera, scale);
    draw_ground_window(picture, frame.field.camera, scale);
    draw_focus_exclusion(picture, frame, content.flow.focus_exclusion);
    if (content.hovered) point_out(picture, frame.step.blocks[*content.hovered], scale);
    if (frame.preview) write_label(picture, {10, 22}, "preview: of the last second only", vermilion);
    return picture;
}

}  // namespace

std::optional<Eigen::Vector2d> FieldPlace::field_px(const cv::Point& at) const {
    if (!area.contains(at)) return std::nullopt;
    return Eigen::Vector2d((at.x - area.x + 0.5) / zoom_x - 0.5, (at.y - area.y + 0.5) / zoom_y - 0.5);
}

cv::Point FieldPlace::panel_px(const Eigen::Vector2d& field_px) const {
    return area.tl() + report::FieldScale{zoom_x, zoom_y}.at(field_px);
}

FieldPlace field_place(const Field& field, const cv::Size& panel) {
    FieldPlace place;
    const double aspect = report::pixel_aspect(field);
    const double room_y = std::max(16, panel.height - legend_px(panel.width));
    const double zoom =
        std::min(panel.width / (1.0 * field.image.width_px), room_y / (aspect * field.image.height_px));
    const cv::Size size(std::max(1, static_cast<int>(zoom * field.image.width_px)),
                        std::max(1, static_cast<int>(zoom * aspect * field.image.height_px)));
    place.area = cv::Rect((panel.width - size.width) / 2, 0, size.width, size.height);
    place.zoom_x = 1.0 * size.width / field.image.width_px;
    place.zoom_y = 1.0 * size.height / field.image.height_px;
    return place;
}

cv::Mat field_panel(const FieldPanelContent& content, const cv::Size& size) {
    cv::Mat panel(size, CV_8UC3, paper);
    const Frame& frame = content.frame;
    if (frame.field.image.empty()) return panel;
    const FieldPlace place = field_place(frame.field, size);
    const cv::Mat picture = marked_picture(content, {place.zoom_x, place.zoom_y});
    const cv::Rect area = place.area & cv::Rect({0, 0}, size);
    picture(cv::Rect({0, 0}, area.size()) & cv::Rect({0, 0}, picture.size())).copyTo(panel(area));
    draw_legend(panel, content, place.area.height + 2);
    return panel;
}

}  // namespace flownav::view
