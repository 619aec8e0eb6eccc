#include "flownav/report/drive_video.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "flownav/cli/number_text.h"
#include "flownav/report/annotated_field.h"

namespace flownav::report {

namespace {

constexpr double period_s = 1.0 / DriveVideo::rate_hz;
constexpr int gap_px = 8;
constexpr int band_px = 48;
constexpr int spare_px = 24;  ///< the legend may grow by a line
constexpr int widest_px = 1920;
const cv::Scalar paper(255, 255, 255);
const cv::Scalar ink(30, 30, 30);

/// H.264 wants even numbers.
int even(int pixels) {
    return pixels + pixels % 2;
}

/// The size of the video for a canvas: no wider than what every player shows.
cv::Size video_size(const cv::Size& canvas) {
    if (canvas.width <= widest_px) return canvas;
    return {widest_px, even(cvRound(1.0 * canvas.height * widest_px / canvas.width))};
}

cv::Size canvas_size(const cv::Mat& field) {
    const int height_px = even(field.rows + spare_px);
    return {even(field.cols + gap_px + height_px - band_px), height_px};
}

/// Puts a picture at the left top of an area, made smaller where it is too large.
void paste(const cv::Mat& area, cv::Mat picture) {
    const double fit = std::min({1.0, 1.0 * area.cols / picture.cols, 1.0 * area.rows / picture.rows});
    if (fit < 1.0) cv::resize(picture, picture, {}, fit, fit, cv::INTER_AREA);
    const cv::Size size(std::min(picture.cols, area.cols), std::min(picture.rows, area.rows));
    picture(cv::Rect({0, 0}, size)).copyTo(area(cv::Rect({0, 0}, size)));
}

cv::Mat composed(const cv::Size& size, const cv::Mat& field, const cv::Mat& map, const std::string& text) {
    cv::Mat canvas(size, CV_8UC3, paper);
    const int map_left = size.width - map.cols;
    paste(canvas.colRange(0, map_left - gap_px), field);
    map.copyTo(canvas(cv::Rect(map_left, 0, map.cols, map.rows)));
    cv::putText(canvas, text, {map_left + 8, map.rows + 30}, cv::FONT_HERSHEY_SIMPLEX, 0.6, ink, 1,
                cv::LINE_AA);
    return canvas;
}

}  // namespace

DriveVideo::DriveVideo(std::filesystem::path file, double map_size_m)
    : file_(std::move(file), rate_hz), map_size_m_(map_size_m) {}

void DriveVideo::remember(const pipeline::Step& step) {
    const Pose2& pose = step.T_start_robot;
    if (!scene_.path.empty()) {
        const Pose2& before = scene_.path.back();
        driven_m_ += std::hypot(pose.x_m - before.x_m, pose.y_m - before.y_m);
    }
    scene_.path.push_back(pose);
    contacts_.take(step);
    if (!step.end_of_cycle) return;
    scene_.points_m.clear();
    for (const ObstaclePoint& point : step.obstacles) {
        scene_.points_m.push_back(transform(pose, point.position_m.head<2>()));
    }
}

void DriveVideo::write(const Field& field, const pipeline::Step& step,
                       const mrpt::maps::COccupancyGridMap2D& map) {
    remember(step);
    const double now_s = field.timestamp_s;
    const bool first = picture_.empty();
    if (first) start_s_ = due_s_ = last_s_ = now_s;
    due_s_ = std::max(due_s_, now_s - longest_pause_s);
    while (due_s_ < now_s - period_s / 2) put();
    last_s_ = now_s;
    if (due_s_ > now_s + period_s / 2) return;
    const cv::Mat annotated = annotated_field(field, step, contacts_.scan());
    scene_.contacts = contact_segments(contacts_.scan(), step.T_start_robot);
    if (first) canvas_px_ = canvas_size(annotated);
    const cv::Mat window = map_window(map, scene_, map_size_m_, canvas_px_.height - band_px);
    const std::string text = "time " + cli::fixed_text(now_s - start_s_, 2) + " s    driven " +
                             cli::fixed_text(driven_m_, 2) + " m";
    cv::resize(composed(canvas_px_, annotated, window, text), picture_, video_size(canvas_px_), 0, 0,
               cv::INTER_AREA);
    put();
}

void DriveVideo::put() {
    file_.write(picture_);
    due_s_ += period_s;
}

}  // namespace flownav::report
