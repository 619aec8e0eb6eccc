#include "flownav/report/map_window.h"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/cli/number_text.h"
#include "flownav/mapping/grid_area.h"
#include "grid_cells.h"

namespace flownav::report {

namespace {

using Grid = mrpt::maps::COccupancyGridMap2D;

const cv::Scalar path_colour(178, 114, 0);  // BGR, the blue of Okabe and Ito
const cv::Scalar point_colour(0, 94, 213);  // their vermillion
const cv::Scalar robot_colour(178, 114, 0);
const cv::Scalar rim(255, 255, 255);
const cv::Scalar ink(30, 30, 30);
constexpr double sub_pixel = 256.0;  // OpenCV draws at fractions of a pixel, given in fixed point
constexpr int sub_pixel_bits = 8;

/// From the map's frame to the picture, whose centre is the robot.
struct Projection {
    Eigen::Vector2d centre_m;
    double px_per_m = 1.0;
    double half_px = 0.0;

    Eigen::Vector2d operator()(const Eigen::Vector2d& place_m) const {
        const Eigen::Vector2d offset = (place_m - centre_m) * px_per_m;
        return {half_px + offset.x(), half_px - offset.y()};
    }

    /// In OpenCV's fixed point, whose pixels have their centre at whole numbers.
    cv::Point fixed(const Eigen::Vector2d& place_m) const {
        const Eigen::Vector2d at = ((*this)(place_m).array() - 0.5) * sub_pixel;
        return {cvRound(at.x()), cvRound(at.y())};
    }
};

cv::Mat background(const Grid& grid, const Projection& projection, double size_m, int size_px) {
    const Eigen::Vector2d corner_m = projection.centre_m.array() - size_m / 2.0;
    const GridArea area = mapping::area_of(grid);
    const double cell_m = area.cell_m;
    const int side = static_cast<int>(std::ceil(size_m / cell_m)) + 2;
    const Eigen::Vector2i corner = area.cell_of(corner_m);
    const cv::Rect part(corner.x(), corner.y(), side, side);
    const double zoom = cell_m * projection.px_per_m;
    const Eigen::Vector2d left_top =
        projection({grid.getXMin() + part.x * cell_m, grid.getYMin() + (part.y + part.height) * cell_m});
    // The centre of the first cell, on the pixel grid of OpenCV.
    const cv::Matx23d warp(zoom, 0, left_top.x() + (zoom - 1) / 2.0, 0, zoom,
                           left_top.y() + (zoom - 1) / 2.0);
    cv::Mat picture;
    cv::warpAffine(grid_cells(grid, part), picture, warp, {size_px, size_px}, cv::INTER_NEAREST,
                   cv::BORDER_CONSTANT, cv::Scalar::all(128));
    cv::cvtColor(picture, picture, cv::COLOR_GRAY2BGR);
    return picture;
}

void draw_path(cv::Mat& picture, const Projection& projection, const std::vector<Pose2>& path) {
    std::vector<cv::Point> line;
    line.reserve(path.size());
    for (const Pose2& pose : path) line.push_back(projection.fixed({pose.x_m, pose.y_m}));
    cv::polylines(picture, line, false, path_colour, 2, cv::LINE_AA, sub_pixel_bits);
}

void draw_points(cv::Mat& picture, const Projection& projection,
                 const std::vector<Eigen::Vector2d>& points_m) {
    const int radius = static_cast<int>(3.5 * sub_pixel);
    for (const Eigen::Vector2d& point_m : points_m) {
        cv::circle(picture, projection.fixed(point_m), radius + 256, rim, cv::FILLED, cv::LINE_AA,
                   sub_pixel_bits);
        cv::circle(picture, projection.fixed(point_m), radius, point_colour, cv::FILLED, cv::LINE_AA,
                   sub_pixel_bits);
    }
}

void draw_robot(cv::Mat& picture, const Projection& projection, const Pose2& pose) {
    const double length_m = 18.0 / projection.px_per_m;
    const auto corner = [&](double bearing_rad, double share) {
        const double direction_rad = pose.yaw_rad + bearing_rad;
        const Eigen::Vector2d offset(std::cos(direction_rad), std::sin(direction_rad));
        return projection.fixed(Eigen::Vector2d(pose.x_m, pose.y_m) + share * length_m * offset);
    };
    const std::array<cv::Point, 4> arrow = {corner(0, 1.2), corner(2.5, 1.0), corner(M_PI, 0.4),
                                            corner(-2.5, 1.0)};
    const std::vector<cv::Point> shape(arrow.begin(), arrow.end());
    cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{shape}, robot_colour, cv::LINE_AA,
                 sub_pixel_bits);
    cv::polylines(picture, shape, true, rim, 2, cv::LINE_AA, sub_pixel_bits);
}

/// 1, 2 or 5 times a power of ten metres, about a quarter of the width.
double bar_length_m(double width_m) {
    const double wanted_m = width_m / 4.0;
    const double power = std::pow(10.0, std::floor(std::log10(wanted_m)));
    const double digit = wanted_m / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

void draw_scale(cv::Mat& picture, double px_per_m) {
    const double length_m = bar_length_m(picture.cols / px_per_m);
    const int length_px = cvRound(length_m * px_per_m);
    const std::string text = cli::fixed_text(length_m, length_m < 1 ? 1 : 0) + " m";
    const int bottom = picture.rows - 16;
    const int text_px = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.5, 1, nullptr).width;
    cv::rectangle(picture, {8, bottom - 10, length_px + text_px + 26, 20}, rim, cv::FILLED);
    cv::rectangle(picture, {14, bottom - 3, length_px, 6}, ink, cv::FILLED);
    cv::putText(picture, text, {22 + length_px, bottom + 5}, cv::FONT_HERSHEY_SIMPLEX, 0.5, ink, 1,
                cv::LINE_AA);
}

}  // namespace

cv::Mat map_window(const Grid& grid, const MapWindowScene& scene, double size_m, int size_px) {
    const Pose2 robot = scene.path.empty() ? Pose2{} : scene.path.back();
    const Projection projection = {{robot.x_m, robot.y_m}, size_px / size_m, size_px / 2.0};
    cv::Mat picture = background(grid, projection, size_m, size_px);
    draw_path(picture, projection, scene.path);
    draw_points(picture, projection, scene.points_m);
    draw_robot(picture, projection, robot);
    draw_scale(picture, projection.px_per_m);
    return picture;
}

}  // namespace flownav::report
