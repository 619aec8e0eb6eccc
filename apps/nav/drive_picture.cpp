#include "drive_picture.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/mapping/grid_area.h"

namespace flownav {
namespace {

using Eigen::Vector2d;

const cv::Scalar way_colour(178, 114, 0);  // BGR, the colours of Okabe and Ito
const cv::Scalar belief_colour(0, 159, 230);
const cv::Scalar contact_colour(0, 94, 213);
const cv::Scalar goal_colour(115, 158, 0);
const cv::Scalar truth_colour(167, 121, 204);
constexpr int sub_pixel_bits = 8;
constexpr double margin_m = 1.0;
constexpr int longest_px = 1000;

/// From the world to the picture.
class Canvas {
  public:
    Canvas(const Vector2d& low_m, const Vector2d& high_m)
        : low_m_(low_m),
          px_per_m_(longest_px / (high_m - low_m).maxCoeff()),
          picture(static_cast<int>((high_m.y() - low_m.y()) * px_per_m_),
                  static_cast<int>((high_m.x() - low_m.x()) * px_per_m_), CV_8UC3, cv::Scalar::all(128)) {}

    cv::Point fixed(const Vector2d& p_m) const {
        const Vector2d at = (p_m - low_m_) * px_per_m_;
        return {cvRound((at.x() - 0.5) * 256), cvRound((picture.rows - at.y() - 0.5) * 256)};
    }

    Vector2d place_m(int u, int v) const {
        return low_m_ + Vector2d(u + 0.5, picture.rows - v - 0.5) / px_per_m_;
    }

    void outline(const std::vector<Vector2d>& corners_m, const cv::Scalar& colour, bool closed, int width) {
        std::vector<cv::Point> points;
        points.reserve(corners_m.size());
        for (const Vector2d& corner : corners_m) points.push_back(fixed(corner));
        cv::polylines(picture, points, closed, colour, width, cv::LINE_AA, sub_pixel_bits);
    }

    void dot(const Vector2d& at_m, double radius_m, const cv::Scalar& colour, int width) {
        const int radius = cvRound(radius_m * px_per_m_ * 256);
        cv::circle(picture, fixed(at_m), radius, colour, width, cv::LINE_AA, sub_pixel_bits);
    }

  private:
    Vector2d low_m_;
    double px_per_m_;

  public:
    cv::Mat picture;
};

void draw_map(Canvas& canvas, const mrpt::maps::COccupancyGridMap2D& map) {
    const GridArea area = mapping::area_of(map);
    for (int v = 0; v < canvas.picture.rows; ++v) {
        for (int u = 0; u < canvas.picture.cols; ++u) {
            const Eigen::Vector2i cell = area.cell_of(canvas.place_m(u, v));
            if (!area.contains(cell)) continue;
            const auto grey = static_cast<std::uint8_t>(255.0F * map.getCell(cell.x(), cell.y()));
            canvas.picture.at<cv::Vec3b>(v, u) = {grey, grey, grey};
        }
    }
}

/// The outline of a solid from above.
std::vector<Vector2d> outline(const sim::Solid& solid, double time_s) {
    const Eigen::Isometry3d pose = pose_at(solid, time_s);
    std::vector<Vector2d> corners;
    if (const auto* box = std::get_if<sim::Box>(&solid.shape)) {
        for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
            const Eigen::Vector3d corner(x * box->size_m.x() / 2, y * box->size_m.y() / 2, 0.0);
            corners.push_back((pose * corner).head<2>());
        }
        return corners;
    }
    const auto* cylinder = std::get_if<sim::Cylinder>(&solid.shape);
    const double radius_m = cylinder ? cylinder->radius_m : std::get<sim::Sphere>(solid.shape).radius_m;
    for (int i = 0; i < 24; ++i) {
        const double angle = i * 2.0 * M_PI / 24;
        corners.push_back(
            (pose * Eigen::Vector3d(radius_m * std::cos(angle), radius_m * std::sin(angle), 0)).head<2>());
    }
    return corners;
}

void draw_robot(Canvas& canvas, const Polygon& footprint, const Pose2& pose, const cv::Scalar& colour) {
    std::vector<Vector2d> corners;
    for (const Vector2d& corner : footprint) corners.push_back(transform(pose, corner));
    canvas.outline(corners, colour, true, 2);
}

}  // namespace

cv::Mat drive_picture(const drive::SimulatedDriveOptions& options, const drive::DriveResult& result,
                      const mrpt::maps::COccupancyGridMap2D& map) {
    Vector2d low(options.start.x_m, options.start.y_m);
    Vector2d high = low;
    const auto include = [&](const Vector2d& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    };
    for (const Vector2d& goal : options.goals_m) include(goal);
    std::vector<Vector2d> way;
    std::vector<Vector2d> belief;
    for (const drive::DriveSample& sample : result.samples) {
        belief.emplace_back(sample.T_map_robot.x_m, sample.T_map_robot.y_m);
        if (sample.truth_known) way.emplace_back(sample.T_world_robot.x_m, sample.T_world_robot.y_m);
        include(sample.truth_known ? way.back() : belief.back());
    }
    const Vector2d around = Vector2d::Constant(2.0 + margin_m);
    Canvas canvas(low - around, high + around);
    draw_map(canvas, map);
    for (const sim::Solid& solid : options.world.solids) {
        if (solid.solid) canvas.outline(outline(solid, result.time_s), truth_colour, true, 1);
    }
    canvas.outline(belief, belief_colour, false, 1);
    canvas.outline(way, way_colour, false, 2);
    for (const Vector2d& goal : options.goals_m) canvas.dot(goal, options.success_radius_m, goal_colour, 2);
    const Polygon& footprint = options.config.navigation.robot.footprint_m;
    if (result.samples.empty()) return canvas.picture;
    const drive::DriveSample& last = result.samples.back();
    const cv::Scalar& colour = last.truth_known ? way_colour : belief_colour;
    draw_robot(canvas, footprint, options.start, colour);
    const bool touched = result.outcome == drive::Outcome::Collision;
    draw_robot(canvas, footprint, last.truth_known ? last.T_world_robot : last.T_map_robot,
               touched ? contact_colour : colour);
    return canvas.picture;
}

}  // namespace flownav
