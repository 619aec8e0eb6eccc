#include "flownav/report/map_window.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/cli/number_text.h"
#include "flownav/report/cause_style.h"
#include "flownav/report/map_canvas.h"
#include "flownav/report/palette.h"

namespace flownav::report {

namespace {

constexpr Colour rim = palette::paper;

void draw_points(MapCanvas& canvas, const std::vector<Eigen::Vector2d>& points_m) {
    constexpr double radius_px = 3.5;
    for (const Eigen::Vector2d& point_m : points_m) {
        canvas.draw_circle(point_m, radius_px + 1.0, rim, cv::FILLED);
        canvas.draw_circle(point_m, radius_px, palette::vermilion, cv::FILLED);
    }
}

void draw_contacts(MapCanvas& canvas, const std::vector<ContactSegment>& contacts) {
    for (const ContactSegment& contact : contacts) {
        const Colour colour = colour_of(contact.cause);
        canvas.draw_line({contact.near_m, contact.far_m}, colour, 1);
        canvas.draw_line({contact.right_m, contact.left_m}, palette::ink, 5);
        canvas.draw_line({contact.right_m, contact.left_m}, colour, 3);
    }
}

/// An arrow head that points where the robot looks.
void draw_robot(MapCanvas& canvas, const Pose2& pose) {
    const double length_m = 18.0 / canvas.px_per_m();
    const auto corner = [&](double bearing_rad, double share) {
        const double direction_rad = pose.yaw_rad + bearing_rad;
        const Eigen::Vector2d offset(std::cos(direction_rad), std::sin(direction_rad));
        return Eigen::Vector2d(Eigen::Vector2d(pose.x_m, pose.y_m) + share * length_m * offset);
    };
    const Polygon arrow = {corner(0, 1.2), corner(2.5, 1.0), corner(M_PI, 0.4), corner(-2.5, 1.0)};
    canvas.fill(arrow, palette::blue);
    canvas.draw_outline(arrow, rim, 2);
}

/// 1, 2 or 5 times a power of ten metres, about a quarter of the width.
double bar_length_m(double width_m) {
    const double wanted_m = width_m / 4.0;
    const double power = std::pow(10.0, std::floor(std::log10(wanted_m)));
    const double digit = wanted_m / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

void draw_scale(MapCanvas& canvas) {
    cv::Mat& picture = canvas.picture();
    const double length_m = bar_length_m(picture.cols / canvas.px_per_m());
    const int length_px = cvRound(length_m * canvas.px_per_m());
    const std::string text = cli::fixed_text(length_m, length_m < 1 ? 1 : 0) + " m";
    const int bottom = picture.rows - 16;
    const int text_px = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, 0.5, 1, nullptr).width;
    cv::rectangle(picture, {8, bottom - 10, length_px + text_px + 26, 20}, rim, cv::FILLED);
    cv::rectangle(picture, {14, bottom - 3, length_px, 6}, palette::ink, cv::FILLED);
    cv::putText(picture, text, {22 + length_px, bottom + 5}, cv::FONT_HERSHEY_SIMPLEX, 0.5, palette::ink, 1,
                cv::LINE_AA);
}

}  // namespace

cv::Mat map_window(const mrpt::maps::COccupancyGridMap2D& grid, const MapWindowScene& scene, double size_m,
                   int size_px) {
    const Pose2 robot = scene.path.empty() ? Pose2{} : scene.path.back();
    const Eigen::Vector2d middle_px = Eigen::Vector2d::Constant(size_px / 2.0);
    MapCanvas canvas({robot.x_m, robot.y_m}, middle_px, size_px / size_m, {size_px, size_px});
    canvas.draw_map(grid);
    canvas.draw_line(positions_m(scene.path), palette::blue, 2);
    draw_points(canvas, scene.points_m);
    draw_contacts(canvas, scene.contacts);
    draw_robot(canvas, robot);
    draw_scale(canvas);
    return canvas.picture();
}

}  // namespace flownav::report
