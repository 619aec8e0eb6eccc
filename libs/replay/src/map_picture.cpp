#include "flownav/replay/map_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "flownav/replay/number_text.h"

namespace flownav {

namespace {

constexpr float unknown_band = 0.02F;
constexpr int margin_cells = 5;
constexpr double wanted_px = 740.0;
constexpr int largest_zoom = 12;
constexpr int band_px = 40;
const cv::Scalar path_colour(178, 114, 0);  // BGR, the blue of Okabe and Ito
const cv::Scalar start_colour(115, 158, 0);
const cv::Scalar end_colour(0, 94, 213);
const cv::Scalar ink(30, 30, 30);

using Grid = mrpt::maps::COccupancyGridMap2D;

cv::Rect known_part(const Grid& grid) {
    cv::Rect known;
    const int columns = static_cast<int>(grid.getSizeX());
    const int rows = static_cast<int>(grid.getSizeY());
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            if (std::abs(grid.getCell(x, y) - 0.5F) > unknown_band) known |= cv::Rect(x, y, 1, 1);
        }
    }
    return known;
}

cv::Rect path_part(const Grid& grid, const std::vector<FieldRow>& rows) {
    cv::Rect part;
    for (const FieldRow& row : rows) {
        const Pose2& pose = row.T_start_robot;
        part |= cv::Rect(grid.x2idx(pose.x_m), grid.y2idx(pose.y_m), 1, 1);
    }
    return part;
}

/// One pixel a cell, y up. Outside the grid MRPT returns 0.5, unknown.
cv::Mat cells(const Grid& grid, const cv::Rect& part) {
    cv::Mat picture(part.size(), CV_8UC1, cv::Scalar(128));
    for (int row = 0; row < part.height; ++row) {
        for (int column = 0; column < part.width; ++column) {
            const int x = part.x + column;
            const int y = part.y + part.height - 1 - row;
            picture.at<std::uint8_t>(row, column) =
                static_cast<std::uint8_t>(std::lround(255 * grid.getCell(x, y)));
        }
    }
    return picture;
}

/// From metres to pixels of the enlarged picture.
struct Projection {
    double left_m = 0.0;
    double top_m = 0.0;
    double px_per_m = 1.0;

    cv::Point at(const Pose2& pose) const {
        return {cvRound((pose.x_m - left_m) * px_per_m), cvRound((top_m - pose.y_m) * px_per_m)};
    }
};

void draw_path(cv::Mat& picture, const Projection& projection, const std::vector<FieldRow>& rows) {
    if (rows.empty()) return;
    std::vector<cv::Point> path;
    path.reserve(rows.size());
    for (const FieldRow& row : rows) path.push_back(projection.at(row.T_start_robot));
    cv::polylines(picture, path, false, path_colour, 2, cv::LINE_AA);
    cv::circle(picture, path.front(), 6, start_colour, cv::FILLED, cv::LINE_AA);
    cv::circle(picture, path.back(), 6, end_colour, cv::FILLED, cv::LINE_AA);
}

/// 1, 2 or 5 times a power of ten metres that fit well into the width.
double bar_length_m(double width_m) {
    const double power = std::pow(10.0, std::floor(std::log10(width_m / 3)));
    const double digit = width_m / 3 / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

cv::Mat scale_band(int width_px, double px_per_m) {
    cv::Mat band(band_px, width_px, CV_8UC3, cv::Scalar::all(255));
    const double length_m = bar_length_m(width_px / px_per_m);
    const int length_px = cvRound(length_m * px_per_m);
    cv::rectangle(band, {8, 16, length_px, 7}, ink, cv::FILLED);
    cv::putText(band, fixed_text(length_m, length_m < 1 ? 1 : 0) + " m", {16 + length_px, 25},
                cv::FONT_HERSHEY_SIMPLEX, 0.5, ink, 1, cv::LINE_AA);
    return band;
}

}  // namespace

cv::Mat map_picture(const Grid& grid, const std::vector<FieldRow>& rows) {
    cv::Rect part = known_part(grid);
    if (part.empty()) return {};
    part |= path_part(grid, rows);
    part = cv::Rect(part.x - margin_cells, part.y - margin_cells, part.width + 2 * margin_cells,
                    part.height + 2 * margin_cells);
    const int longest = std::max(part.width, part.height);
    const double zoom = longest < wanted_px
                            ? std::clamp(std::floor(wanted_px / longest), 1.0, 1.0 * largest_zoom)
                            : wanted_px / longest;
    cv::Mat picture = cells(grid, part);
    cv::resize(picture, picture, {}, zoom, zoom, zoom < 1 ? cv::INTER_AREA : cv::INTER_NEAREST);
    cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
    const double resolution_m = grid.getResolution();
    const Projection projection = {grid.getXMin() + part.x * resolution_m,
                                   grid.getYMin() + (part.y + part.height) * resolution_m,
                                   zoom / resolution_m};
    draw_path(picture, projection, rows);
    cv::Mat result;
    cv::vconcat(picture, scale_band(picture.cols, projection.px_per_m), result);
    return result;
}

}  // namespace flownav
