#include "ink.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace flownav::view {

namespace {
constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr int mark_px = 22;
constexpr int gap_px = 14;
}  // namespace

int text_width(const std::string& text, double scale) {
    return cv::getTextSize(text, font, scale, 1, nullptr).width;
}

void write_text(cv::Mat& picture, const cv::Point& at, const std::string& text, const cv::Scalar& colour,
                double scale) {
    cv::putText(picture, text, at, font, scale, colour, 1, cv::LINE_AA);
}

void write_label(cv::Mat& picture, const cv::Point& at, const std::string& text, const cv::Scalar& colour) {
    const cv::Rect wanted(at.x - 3, at.y - 13, text_width(text) + 6, 18);
    const cv::Rect area = wanted & cv::Rect({0, 0}, picture.size());
    if (area.empty()) return;
    cv::Mat ground = picture(area);
    cv::addWeighted(ground, 0.25, cv::Mat(ground.size(), ground.type(), paper), 0.75, 0, ground);
    write_text(picture, at, text, colour);
}

std::string fitted(const std::string& text, int width_px, double scale) {
    if (text_width(text, scale) <= width_px) return text;
    std::string shorter = text;
    while (!shorter.empty() && text_width(shorter + "...", scale) > width_px) shorter.pop_back();
    return shorter + "...";
}

void dashed_line(cv::Mat& picture, const cv::Point& from, const cv::Point& to, const cv::Scalar& colour) {
    constexpr double dash_px = 5.0;
    const double length = cv::norm(to - from);
    const int dashes = std::max(1, cvRound(length / dash_px));
    for (int i = 0; i < dashes; i += 2) {
        const cv::Point2d step = cv::Point2d(to - from) / dashes;
        cv::line(picture, cv::Point2d(from) + step * i, cv::Point2d(from) + step * std::min(i + 1, dashes),
                 colour, 1, cv::LINE_AA);
    }
}

void LegendRow::add(const std::string& text, const cv::Scalar& colour, Mark mark) {
    const int width_px = mark_px + text_width(text);
    if (x_ > area_.x && x_ + width_px > area_.x + area_.width) {
        x_ = area_.x;
        y_ += line_px;
    }
    const int middle = y_ + line_px / 2;
    switch (mark) {
        case Mark::Box:
            cv::rectangle(picture_, {x_ + 2, middle - 5, 12, 11}, colour, cv::FILLED);
            break;
        case Mark::Line:
            cv::line(picture_, {x_, middle}, {x_ + 16, middle}, colour, 2, cv::LINE_AA);
            break;
        case Mark::Dash:
            dashed_line(picture_, {x_, middle}, {x_ + 16, middle}, colour);
            break;
        case Mark::Dot:
            cv::circle(picture_, {x_ + 8, middle}, 4, colour, cv::FILLED, cv::LINE_AA);
            break;
    }
    write_text(picture_, {x_ + mark_px - 2, middle + 5}, text);
    x_ += width_px + gap_px;
}

double round_step(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
    const double digit = value / power;
    return power * (digit <= 1.0 ? 1 : digit <= 2.0 ? 2 : digit <= 5.0 ? 5 : 10);
}

}  // namespace flownav::view
