#include "flownav/report/field_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace flownav::report {

namespace {

constexpr int block_px = 16;
constexpr double shortest_arrow_px = 6.0;
const cv::Scalar rim(25, 25, 25);

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

}  // namespace

CameraModel camera_in_use(const Field& field, const pipeline::Step& step) {
    CameraModel camera = field.camera;
    camera.mount.pitch_rad += step.pitch_correction_rad;
    return camera;
}

double pixel_aspect(const Field& field) {
    const double stretch = field.camera.fy_px > 0 ? field.camera.fx_px / field.camera.fy_px : 1.0;
    return std::clamp(stretch, 0.5, 2.0);
}

cv::Mat scaled_field(const Field& field, const FieldScale& scale) {
    const ImageView& view = field.image;
    const cv::Mat grey(view.height_px, view.width_px, CV_8UC1, const_cast<std::uint8_t*>(view.data),
                       static_cast<std::size_t>(view.stride_bytes));
    cv::Mat picture;
    cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
    cv::resize(picture, picture, {}, scale.x, scale.y, scale.x < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
    return picture;
}

bool is_drawn(const pipeline::BlockRecord& block, BlockLabel label) {
    return block.label == label && (block.vector.valid || label == BlockLabel::Sifted);
}

void tint_blocks(cv::Mat& picture, const pipeline::Step& step, const FieldScale& scale,
                 const LabelStyle& style) {
    const Eigen::Vector2d half(block_px / 2.0, block_px / 2.0);
    const bool strong = style.label == BlockLabel::Obstacle || style.label == BlockLabel::Moving ||
                        style.label == BlockLabel::Unsupported;
    for (const auto& block : step.blocks) {
        if (!is_drawn(block, style.label) || style.label == BlockLabel::Sifted) continue;
        const Eigen::Vector2d now = block.vector.at_px + block.vector.flow_px;
        const cv::Rect area =
            cv::Rect(scale.at(now - half), scale.at(now + half)) & cv::Rect({0, 0}, picture.size());
        if (area.empty()) continue;
        cv::Mat patch = picture(area);
        const double share = (strong ? 0.45 : 0.2) * (scale.x > 2 ? 0.5 : 1.0);  // enlarged blocks overlap
        cv::addWeighted(patch, 1 - share, cv::Mat(patch.size(), patch.type(), style.colour), share, 0, patch);
        if (strong) cv::rectangle(picture, area, style.colour, 1);
    }
}

void draw_vectors(cv::Mat& picture, const pipeline::Step& step, const FieldScale& scale,
                  const LabelStyle& style) {
    for (const auto& block : step.blocks) {
        if (!is_drawn(block, style.label)) continue;
        const cv::Point from = scale.at(block.vector.at_px);
        if (style.label == BlockLabel::Sifted) {
            cv::circle(picture, from, 2, style.colour, cv::FILLED, cv::LINE_AA);
            continue;
        }
        const cv::Point to = scale.at(block.vector.at_px + block.vector.flow_px);
        draw_arrow(picture, from, to, style.colour);
    }
}

}  // namespace flownav::report
