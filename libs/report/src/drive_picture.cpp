#include "flownav/report/drive_picture.h"

#include "flownav/report/map_canvas.h"
#include "flownav/report/palette.h"

namespace flownav::report {
namespace {

using Eigen::Vector2d;

constexpr double margin_m = 3.0;
constexpr double longest_px = 1000.0;

/// A canvas that holds start, goals and way, with the margin around them.
MapCanvas canvas_for(const DriveScene& scene) {
    Vector2d low(scene.start.x_m, scene.start.y_m);
    Vector2d high = low;
    const auto include = [&](const Vector2d& p_m) {
        low = low.cwiseMin(p_m);
        high = high.cwiseMax(p_m);
    };
    for (const Vector2d& goal_m : scene.goals_m) include(goal_m);
    for (const Pose2& pose : scene.true_way.empty() ? scene.believed : scene.true_way)
        include({pose.x_m, pose.y_m});
    low.array() -= margin_m;
    high.array() += margin_m;
    const double px_per_m = longest_px / (high - low).maxCoeff();
    const cv::Size size_px(static_cast<int>((high.x() - low.x()) * px_per_m),
                           static_cast<int>((high.y() - low.y()) * px_per_m));
    return {low, Vector2d(0.0, size_px.height), px_per_m, size_px};
}

void draw_robot(MapCanvas& canvas, const Polygon& footprint_m, const Pose2& pose, const Colour& colour) {
    Polygon corners_m;
    for (const Vector2d& corner_m : footprint_m) corners_m.push_back(transform(pose, corner_m));
    canvas.draw_outline(corners_m, colour, 2);
}

}  // namespace

cv::Mat drive_picture(const DriveScene& scene, const mrpt::maps::COccupancyGridMap2D& map) {
    MapCanvas canvas = canvas_for(scene);
    canvas.draw_map(map);
    for (const Polygon& outline_m : scene.outlines_m) canvas.draw_outline(outline_m, palette::purple, 1);
    canvas.draw_line(positions_m(scene.believed), palette::orange, 1);
    canvas.draw_line(positions_m(scene.true_way), palette::blue, 2);
    for (const Vector2d& goal_m : scene.goals_m)
        canvas.draw_circle(goal_m, scene.goal_radius_m * canvas.px_per_m(), palette::green, 2);
    if (!scene.end) return canvas.picture();
    const Colour way = scene.true_way.empty() ? palette::orange : palette::blue;
    draw_robot(canvas, scene.footprint_m, scene.start, way);
    draw_robot(canvas, scene.footprint_m, *scene.end, scene.touched ? palette::vermilion : way);
    return canvas.picture();
}

}  // namespace flownav::report
