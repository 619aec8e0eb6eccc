#pragma once
#include <opencv2/core/mat.hpp>
#include <string>

namespace flownav::view {

// Colours, BGR; those with a name are of the palette of Okabe and Ito.
const cv::Scalar paper(255, 255, 255);
const cv::Scalar ink(30, 30, 30);
const cv::Scalar faint(225, 225, 225);
const cv::Scalar grey(130, 130, 130);
const cv::Scalar orange(0, 159, 230);
const cv::Scalar sky_blue(233, 180, 86);
const cv::Scalar green(115, 158, 0);
const cv::Scalar yellow(66, 228, 240);
const cv::Scalar blue(178, 114, 0);
const cv::Scalar vermilion(0, 94, 213);
const cv::Scalar purple(167, 121, 204);

constexpr double text_scale = 0.45;
constexpr int line_px = 19;  ///< from one line of text to the next

int text_width(const std::string& text, double scale = text_scale);

/// Writes with the baseline's left end at `at`.
void write_text(cv::Mat& picture, const cv::Point& at, const std::string& text,
                const cv::Scalar& colour = ink, double scale = text_scale);

/// The same on a light ground, to be read above a picture.
void write_label(cv::Mat& picture, const cv::Point& at, const std::string& text,
                 const cv::Scalar& colour = ink);

/// The part of `text` that is no wider than `width_px`, with "..." where something is missing.
std::string fitted(const std::string& text, int width_px, double scale = text_scale);

/// A line of dashes.
void dashed_line(cv::Mat& picture, const cv::Point& from, const cv::Point& to, const cv::Scalar& colour);

/// Entries of a legend in a row, wrapped at the right edge of `area`; returns the height used.
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

/// 1, 2 or 5 times a power of ten, not below `value`.
double round_step(double value);

}  // namespace flownav::view
