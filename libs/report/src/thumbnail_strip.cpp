#include "flownav/report/thumbnail_strip.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "flownav/report/annotated_field.h"
#include "flownav/report/field_drawing.h"

namespace flownav::report {

namespace {

struct Look {
    double area_px;
    double widest_px;
    int jpeg_quality;
};
constexpr Look large_look = {720.0 * 540.0, 1100.0, 70};
constexpr Look small_look = {640.0 * 480.0, 980.0, 55};

/// Of a picture that is `tall` times as high as wide.
double width_px(const Look& look, double tall) {
    return std::min(look.widest_px, std::sqrt(look.area_px / tall));
}

std::vector<std::uint8_t> encoded(const cv::Mat& picture, const Look& look) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, look.jpeg_quality});
    return bytes;
}

std::vector<std::uint8_t> jpeg_of(const Field& field, const pipeline::Step& step, const ContactScan& contacts,
                                  const Look& look) {
    const double aspect = pixel_aspect(field);
    const double tall = field.image.height_px * aspect / field.image.width_px;
    const double zoom = width_px(look, tall) / field.image.width_px;
    return encoded(marked_field(field, step, contacts, {zoom, zoom * aspect}), look);
}

std::vector<std::uint8_t> shrunk(const std::vector<std::uint8_t>& jpeg) {
    cv::Mat picture = cv::imdecode(jpeg, cv::IMREAD_COLOR);
    const double zoom = width_px(small_look, 1.0 * picture.rows / picture.cols) / picture.cols;
    cv::resize(picture, picture, {}, zoom, zoom, cv::INTER_AREA);
    return encoded(picture, small_look);
}

ThumbnailStrip::Picture picture_of(const Field& field, const pipeline::Step& step,
                                   const ContactScan& contacts, const Look& look) {
    ThumbnailStrip::Picture picture;
    picture.timestamp_s = step.timestamp_s;
    picture.labels = evaluation::label_counts_of(step);
    for (const ObstaclePoint& point : step.obstacles) {
        const Eigen::Vector2d at_m = point.position_m.head<2>();
        picture.points_m.push_back(transform(step.T_start_robot, at_m));
    }
    picture.strips = counts_of(contacts);
    picture.contacts = contact_segments(contacts, step.T_start_robot);
    picture.jpeg = jpeg_of(field, step, contacts, look);
    return picture;
}

}  // namespace

/// Takes the picture that is being drawn.
void ThumbnailStrip::settle() {
    if (!pending_.valid()) return;
    pictures_.push_back(pending_.get());
    bytes_ += pictures_.back().jpeg.size();
    while (bytes_ > most_bytes && pictures_.size() > 1) make_room();
}

bool ThumbnailStrip::is_due(const pipeline::Step& step) const {
    if (pictures_.empty()) return true;
    const bool overdue = step.timestamp_s >= due_s_ + interval_s_;
    return overdue || (step.end_of_cycle && step.timestamp_s >= due_s_);
}

void ThumbnailStrip::offer(const Field& field, const pipeline::Step& step) {
    contacts_.take(step);
    const bool begun = pending_.valid() || !pictures_.empty();
    if (begun && step.timestamp_s < due_s_) return;
    settle();  // the room that the last one takes may put off the next
    if (!is_due(step)) return;
    const bool first = pictures_.empty();
    if (!first && !has_better_than_first_) {
        // The first field shows no vector: it is kept only while there is nothing else.
        pictures_.clear();
        bytes_ = 0;
        has_better_than_first_ = true;
    }
    // Without a thread to spare it is drawn when it is asked for.
    const auto how = std::launch::deferred | (in_background_ ? std::launch::async : std::launch::deferred);
    pending_ =
        std::async(how, [field, step, contacts = contacts_.scan(), look = small_ ? small_look : large_look] {
            return picture_of(field, step, contacts, look);
        });
    due_s_ = step.timestamp_s + (first ? 0.0 : interval_s_);
    if (!in_background_) settle();
}

void ThumbnailStrip::make_room() {
    if (small_) {
        thin_out();
    } else {
        shrink();
    }
}

void ThumbnailStrip::shrink() {
    small_ = true;
    bytes_ = 0;
    for (Picture& picture : pictures_) {
        picture.jpeg = shrunk(picture.jpeg);
        bytes_ += picture.jpeg.size();
    }
}

/// Every second one goes, and from now on they come half as often.
void ThumbnailStrip::thin_out() {
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

}  // namespace flownav::report
