#include "flownav/replay/filmstrip.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "flownav/replay/annotated_field.h"
#include "flownav/replay/field_drawing.h"

namespace flownav {

namespace {

constexpr double area_px = 720.0 * 540.0;
constexpr double widest_px = 1100.0;
constexpr int jpeg_quality = 70;

std::vector<std::uint8_t> jpeg_of(const Field& field, const pipeline::Step& step) {
    const double tall = field.image.height_px * pixel_aspect(field) / field.image.width_px;
    const double zoom = std::min(widest_px, std::sqrt(area_px / tall)) / field.image.width_px;
    const cv::Mat picture = marked_field(field, step, {zoom, zoom * pixel_aspect(field)});
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality});
    return bytes;
}

Filmstrip::Picture picture_of(const Field& field, const pipeline::Step& step) {
    Filmstrip::Picture picture;
    picture.timestamp_s = step.timestamp_s;
    picture.fates = fates_of(step);
    for (const ObstaclePoint& point : step.obstacles)
        picture.points_m.push_back(
            transform(step.T_start_robot, Eigen::Vector2d(point.position_m.head<2>())));
    picture.jpeg = jpeg_of(field, step);
    return picture;
}

}  // namespace

bool Filmstrip::is_due(const pipeline::Step& step) const {
    if (pictures_.empty()) return true;
    const bool overdue = step.timestamp_s >= due_s_ + interval_s_;
    return overdue || (step.end_of_cycle && step.timestamp_s >= due_s_);
}

void Filmstrip::offer(const Field& field, const pipeline::Step& step) {
    if (!is_due(step)) return;
    const bool first = pictures_.empty();
    if (!first && !has_better_than_first_) {
        // The first field shows no vector: it is kept only while there is nothing else.
        pictures_.clear();
        bytes_ = 0;
        has_better_than_first_ = true;
    }
    pictures_.push_back(picture_of(field, step));
    bytes_ += pictures_.back().jpeg.size();
    due_s_ = step.timestamp_s + (first ? 0.0 : interval_s_);
    while (bytes_ > most_bytes && pictures_.size() > 1) thin_out();
}

/// Every second one goes, and from now on they come half as often.
void Filmstrip::thin_out() {
    std::vector<Picture> kept;
    bytes_ = 0;
    for (std::size_t i = 0; i < pictures_.size(); i += 2) {
        bytes_ += pictures_[i].jpeg.size();
        kept.push_back(std::move(pictures_[i]));
    }
    pictures_ = std::move(kept);
    interval_s_ *= 2;
    due_s_ = pictures_.back().timestamp_s + interval_s_;
}

}  // namespace flownav
