#pragma once
#include <opencv2/core/mat.hpp>
#include <string>

#include "flownav/report/palette.h"

namespace flownav::view {

// Colours as OpenCV draws them.
const cv::Scalar paper = report::palette::paper;
const cv::Scalar ink = report::palette::ink;
const cv::Scalar faint(225, 225, 225);
const cv::Scalar grey(130, 130, 130);
const cv::Scalar orange = report::palette::orange;
const cv::Scalar sky_blue = report::palette::sky_blue;
const cv::Scalar green = report::palette::green;
const cv::Scalar yellow = report::palette::yellow;
const cv::Scalar blue = report::palette::blue;
const cv::Scalar vermilion = report::palette::vermilion;
const cv::Scalar purple = report::palette::purple;

constexpr double text_scale = 0.45;
constexpr int line_px = 19;  ///< line spacing of text

int text_width(const std::string& text, double scale = text_scale);

/// Draws text with the left end of its baseline at `at`.
void write_text(cv::Mat& picture, const cv::Point& at, const std::string& text,
                const cv::Scalar& colour = ink, double scale = text_scale);

/// Draws text on a light ground, readable above a picture.
void write_label(cv::Mat& picture, const cv::Point& at, const std::string& text,
                 const cv::Scalar& colour = ink);

/// Shortens `text` to `width_px`; "..." replaces the removed part.
std::string fitted(const std::string& text, int width_px, double scale = text_scale);

/// Draws a dashed line.
void dashed_line(cv::Mat& picture, const cv::Point& from, const cv::Point& to, const cv::Scalar& colour);

/// Draws the entries of a legend in a row, wrapped at the right edge of `area`; returns the height used.
class LegendRow {
  public:
    enum class Mark { Box, Line, Dash, Dot };

    LegendRow(cv::Mat& picture, const cv::Rect& area) : picture_(picture), area_(area), x_(area.x) {}
    void add(const std::string& text, const cv::Scalar& colour, Mark mark = Mark::Box);
    int bottom() const { return y_ + line_px; }

  private:
    cv::Mat& picture_;
    cv::Rect area_;
    int x_;
    int y_ = area_.y;
};

/// Smallest 1, 2 or 5 times a power of ten that is not below `value`.
double round_step(double value);

}  // namespace flownav::view
