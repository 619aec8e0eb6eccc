#include "flownav/report/map_canvas.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/mapping/grid_area.h"
#include "grid_cells.h"

namespace flownav::report {

namespace {

using Eigen::Vector2d;

constexpr double sub_pixel = 256.0;  // OpenCV takes fractions of a pixel in fixed point
constexpr int sub_pixel_bits = 8;
const cv::Scalar unknown = cv::Scalar::all(128);

}  // namespace

MapCanvas::MapCanvas(const Vector2d& at_m, const Vector2d& at_px, double px_per_m, const cv::Size& size_px)
    : at_m_(at_m), at_px_(at_px), px_per_m_(px_per_m), picture_(size_px, CV_8UC3, unknown) {}

Vector2d MapCanvas::pixel_of(const Vector2d& place_m) const {
    const Vector2d offset = (place_m - at_m_) * px_per_m_;
    return {at_px_.x() + offset.x(), at_px_.y() - offset.y()};
}

Vector2d MapCanvas::place_of(const Vector2d& px) const {
    return at_m_ + Vector2d(px.x() - at_px_.x(), at_px_.y() - px.y()) / px_per_m_;
}

/// In OpenCV's fixed point, where the centre of a pixel is a whole number.
cv::Point MapCanvas::fixed(const Vector2d& place_m) const {
    const Vector2d at = (pixel_of(place_m).array() - 0.5) * sub_pixel;
    return {cvRound(at.x()), cvRound(at.y())};
}

std::vector<cv::Point> MapCanvas::fixed(const std::vector<Vector2d>& places_m) const {
    std::vector<cv::Point> points;
    points.reserve(places_m.size());
    for (const Vector2d& place_m : places_m) points.push_back(fixed(place_m));
    return points;
}

void MapCanvas::draw_map(const mrpt::maps::COccupancyGridMap2D& grid) {
    const GridArea area = mapping::area_of(grid);
    const auto cells = [&](int length_px) {
        return static_cast<int>(std::ceil(length_px / px_per_m_ / area.cell_m)) + 2;
    };
    const Eigen::Vector2i corner = area.cell_of(place_of({0.0, picture_.rows}));
    const cv::Rect part(corner.x(), corner.y(), cells(picture_.cols), cells(picture_.rows));
    const double zoom = area.cell_m * px_per_m_;
    const Vector2d left_top = pixel_of(
        {grid.getXMin() + part.x * area.cell_m, grid.getYMin() + (part.y + part.height) * area.cell_m});
    // The centre of the first cell, on the pixel grid of OpenCV.
    const cv::Matx23d warp(zoom, 0, left_top.x() + (zoom - 1) / 2.0, 0, zoom,
                           left_top.y() + (zoom - 1) / 2.0);
    cv::Mat grey;
    cv::warpAffine(grid_cells(grid, part), grey, warp, picture_.size(), cv::INTER_NEAREST,
                   cv::BORDER_CONSTANT, unknown);
    cv::cvtColor(grey, picture_, cv::COLOR_GRAY2BGR);
}

void MapCanvas::draw_line(const std::vector<Vector2d>& points_m, const cv::Scalar& colour, int width_px) {
    cv::polylines(picture_, fixed(points_m), false, colour, width_px, cv::LINE_AA, sub_pixel_bits);
}

void MapCanvas::draw_outline(const Polygon& corners_m, const cv::Scalar& colour, int width_px) {
    cv::polylines(picture_, fixed(corners_m), true, colour, width_px, cv::LINE_AA, sub_pixel_bits);
}

void MapCanvas::fill(const Polygon& corners_m, const cv::Scalar& colour) {
    cv::fillPoly(picture_, std::vector<std::vector<cv::Point>>{fixed(corners_m)}, colour, cv::LINE_AA,
                 sub_pixel_bits);
}

void MapCanvas::draw_circle(const Vector2d& middle_m, double radius_px, const cv::Scalar& colour,
                            int width_px) {
    cv::circle(picture_, fixed(middle_m), cvRound(radius_px * sub_pixel), colour, width_px, cv::LINE_AA,
               sub_pixel_bits);
}

std::vector<Vector2d> positions_m(const std::vector<Pose2>& poses) {
    std::vector<Vector2d> positions;
    positions.reserve(poses.size());
    for (const Pose2& pose : poses) positions.emplace_back(pose.x_m, pose.y_m);
    return positions;
}

}  // namespace flownav::report
