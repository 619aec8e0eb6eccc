#include "lidar_pictures.h"

#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <stdexcept>

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double cell_m = 0.25;
constexpr double px_per_m = 12.0;
constexpr double colour_range_m = 25.0;

cv::Scalar colour_of(double range_m) {
    cv::Mat hue(1, 1, CV_8UC3, cv::Scalar(std::min(1.0, range_m / colour_range_m) * 130, 255, 255));
    cv::cvtColor(hue, hue, cv::COLOR_HSV2BGR);
    const auto bgr = hue.at<cv::Vec3b>(0, 0);
    return {static_cast<double>(bgr[0]), static_cast<double>(bgr[1]), static_cast<double>(bgr[2])};
}

cv::Point at(const Vector2d& pixel_px) {
    return {static_cast<int>(std::lround(pixel_px.x())), static_cast<int>(std::lround(pixel_px.y()))};
}

bool is_confirmed(const ObstaclePoint& point, const LidarView& view) {
    const Vector2d at_m = point.position_m.head<2>();
    return nearest_m(view.high_m, at_m) <= tolerance_m(at_m.norm());
}

struct Extent {
    int left = 0, right = 0, low = 0, high = 0;
};

/// Draws all cells as one path of squares, forward up.
std::string path_of(const std::map<std::pair<int, int>, int>& cells, const Extent& extent, const char* fill) {
    const int edge = static_cast<int>(std::lround(cell_m * px_per_m));
    std::ostringstream out;
    out << R"(<path fill=")" << fill << R"(" d=")";
    for (const auto& [cell, points] : cells) {
        out << 'M' << (extent.left - cell.second) * edge << ' ' << (extent.high - cell.first) * edge << 'h'
            << edge << 'v' << edge << 'h' << -edge << 'z';
    }
    out << R"("/>)" << '\n';
    return out.str();
}

}  // namespace

void LidarPlan::add(const pipeline::Step& step, const LidarView& view) {
    const auto cell_of = [&](const Vector2d& robot_m) {
        const Vector2d cell = (transform(step.T_start_robot, robot_m) / cell_m).array().floor();
        return Cell{static_cast<int>(cell.x()), static_cast<int>(cell.y())};
    };
    for (const ObstaclePoint& point : step.obstacles)
        ++(is_confirmed(point, view) ? right_ : wrong_)[cell_of(point.position_m.head<2>())];
    path_m_.emplace_back(step.T_start_robot.x_m, step.T_start_robot.y_m);
}

void LidarPlan::write(const std::filesystem::path& svg) const {
    Extent extent;
    for (const auto* cells : {&right_, &wrong_}) {
        for (const auto& [cell, points] : *cells) {
            extent.high = std::max(extent.high, cell.first + 1);
            extent.left = std::max(extent.left, cell.second + 1);
            extent.right = std::min(extent.right, cell.second - 1);
        }
    }
    const int edge = static_cast<int>(std::lround(cell_m * px_per_m));
    std::ofstream out(svg, std::ios::binary);
    const int width = (extent.left - extent.right + 1) * edge;
    out << R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" << 2 * width << R"(" viewBox="0 0 )" << width
        << ' ' << (extent.high + 5) * edge << R"(" font-family="sans-serif" font-size="9">)" << '\n'
        << R"(<rect width="100%" height="100%" fill="white"/>)" << '\n'
        << path_of(wrong_, extent, "#d62728") << path_of(right_, extent, "#2ca02c")
        << R"(<polyline fill="none" stroke="#1f77b4" points=")";
    for (const Vector2d& at_m : path_m_) {
        out << std::lround((extent.left + 1) * edge - at_m.y() * px_per_m) << ','
            << std::lround((extent.high + 1) * edge - at_m.x() * px_per_m) << ' ';
    }
    out << R"("/><text x="4" y="11">5 m</text><path stroke="black" d="M4 15h)" << 5 * px_per_m
        << R"("/></svg>)" << '\n';
    out.close();
    if (!out) throw std::runtime_error(svg.string() + ": cannot be written");
}

void write_overlay(const std::filesystem::path& folder, int number, const Field& field,
                   const RayMapper& mapper, const pipeline::Step& step, const std::vector<Vector3d>& scan_m,
                   const LidarView& view) {
    const ImageView& image = field.image;
    cv::Mat picture(image.height_px, image.width_px, CV_8UC3);
    for (int v = 0; v < image.height_px; ++v)
        for (int u = 0; u < image.width_px; ++u) picture.at<cv::Vec3b>(v, u) = cv::Vec3b::all(image.at(u, v));
    for (const Vector3d& at_m : scan_m) {
        if (at_m.z() > obstacle_low_m && at_m.head<2>().norm() < colour_range_m)
            cv::circle(picture, at(project(mapper, at_m)), 1, colour_of(at_m.head<2>().norm()), cv::FILLED);
    }
    for (const ObstaclePoint& point : step.obstacles) {
        const cv::Point centre = at(point.at_px);
        const cv::Scalar colour = colour_of(point.position_m.head<2>().norm());
        if (point.moving) {
            cv::rectangle(picture, centre - cv::Point(6, 6), centre + cv::Point(6, 6), colour, 2);
        } else {
            cv::circle(picture, centre, 6, colour, 2);
        }
        if (!is_confirmed(point, view))
            cv::drawMarker(picture, centre, cv::Scalar(255, 0, 255), cv::MARKER_TILTED_CROSS, 14, 2);
    }
    const std::filesystem::path file = folder / (std::to_string(number) + ".png");
    if (!cv::imwrite(file.string(), picture)) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace flownav::fidelity
