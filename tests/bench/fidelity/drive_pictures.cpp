#include "drive_pictures.h"

#include "svg_chart.h"

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;
using Line = std::vector<Vector2d>;
namespace palette = report::palette;

constexpr std::size_t most_points = 500;

Line outline(const sim::Solid& solid) {
    const testing::Upright p = testing::upright_of(solid);
    Line line;
    if (p.shape == testing::UprightShape::Cylinder) {
        constexpr int corners = 8;
        for (int k = 0; k <= corners; ++k) {
            const double angle = 2.0 * M_PI * k / corners;
            line.emplace_back(p.centre_m + p.half_x_m * Vector2d(std::cos(angle), std::sin(angle)));
        }
        return line;
    }
    const Pose2 pose{p.centre_m.x(), p.centre_m.y(), p.yaw_rad};
    for (const auto& [x, y] : {std::pair{1, 1}, std::pair{-1, 1}, std::pair{-1, -1}, std::pair{1, -1}})
        line.push_back(transform(pose, Vector2d(x * p.half_x_m, y * p.half_y_m)));
    line.push_back(line.front());
    return line;
}

Line every_fourth(const Line& path) {
    Line thin;
    for (std::size_t i = 0; i < path.size(); i += 4) thin.push_back(path[i]);
    if (!path.empty()) thin.push_back(path.back());
    return thin;
}

ChartSeries things(const sim::World& world) {
    ChartSeries series{"things", palette::grey, {}, false, 1.0};
    for (const sim::Solid& p : world.solids) series.pieces.push_back(outline(p));
    return series;
}

Chart plan(const std::string& title) {
    Chart chart;
    chart.title = title;
    chart.x_label = "x (m)";
    chart.y_label = "y (m)";
    chart.equal_scales = true;
    return chart;
}

}  // namespace

std::string paths_picture(const DriveRecord& drive) {
    Chart chart = plan("Once around a railing and a chair");
    chart.series = {things(drive.world),
                    {"truth", palette::ink, {every_fourth(drive.truth_m)}, false, 3.0},
                    {"wheel odometry", palette::vermilion, {every_fourth(drive.odometry_m)}, true, 1.5},
                    {"flow odometry", palette::blue, {every_fourth(drive.flow_m)}, false, 1.5}};
    return svg_file(chart);
}

std::string points_picture(const DriveRecord& drive) {
    Chart chart = plan("Obstacle points of the drive");
    ChartSeries dots{"points", palette::purple, {}, false, 1.0};
    const std::size_t step = drive.points.size() / most_points + 1;
    for (std::size_t i = 0; i < drive.points.size(); i += step)
        dots.pieces.push_back({drive.points[i].in_world_m});
    chart.series = {
        things(drive.world), dots, {"path", palette::ink, {every_fourth(drive.truth_m)}, true, 1.0}};
    return svg_file(chart);
}

}  // namespace flownav::fidelity
