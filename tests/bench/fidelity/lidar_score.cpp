#include "lidar_score.h"

#include <cmath>

namespace flownav::fidelity {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t thing_cells_min = 4;
constexpr double touching_m = 1.5 * lidar_cell_m;

std::size_t band_of(double range_m) {
    std::size_t band = 0;
    while (band + 1 < lidar_range_ends_m.size() && range_m > lidar_range_ends_m.at(band)) ++band;
    return band;
}

/// Groups cells that touch each other.
std::vector<std::vector<Vector2d>> things_of(std::vector<Vector2d> cells_m) {
    std::vector<std::vector<Vector2d>> things;
    while (!cells_m.empty()) {
        std::vector<Vector2d> thing_m{cells_m.back()};
        cells_m.pop_back();
        for (std::size_t i = 0; i < thing_m.size(); ++i) {
            const auto touches = [&](const Vector2d& c) { return (c - thing_m[i]).norm() < touching_m; };
            const auto rest = std::stable_partition(cells_m.begin(), cells_m.end(),
                                                    [&](const Vector2d& c) { return !touches(c); });
            const std::vector<Vector2d> more_m(rest, cells_m.end());
            cells_m.erase(rest, cells_m.end());
            thing_m.insert(thing_m.end(), more_m.begin(), more_m.end());
        }
        if (thing_m.size() >= thing_cells_min) things.push_back(std::move(thing_m));
    }
    return things;
}

}  // namespace

LidarJudge::LidarJudge(const CameraModel& camera, const config::Config& config)
    : mapper_(camera), config_(config), layout_(flow::place_blocks(mapper_, config.pipeline.flow)) {}

void LidarJudge::see(const pipeline::Step& step, const std::vector<Vector3d>& scan_m,
                     const std::vector<Vector3d>& reference_scan_m) {
    view_ = lidar_view(scan_m, mapper_, layout_, config_.pipeline.obstacles.range_max_m);
    const std::vector<Vector2d> lately_m = points_lately(step);
    ++score_.cycles;
    see_points(step);
    see_cells(moments_.back().points_m, lately_m);
    see_blocks(step, reference_scan_m);
}

std::vector<Vector2d> LidarJudge::points_lately(const pipeline::Step& step) {
    Moment now{step.timestamp_s, step.T_start_robot, {}};
    for (const ObstaclePoint& point : step.obstacles) now.points_m.emplace_back(point.position_m.head<2>());
    moments_.push_back(now);
    while (moments_.front().timestamp_s < now.timestamp_s - lately_s) moments_.pop_front();
    std::vector<Vector2d> points_m;
    for (const Moment& moment : moments_) {
        const Pose2 T_now_then = compose(inverse(now.T_start_robot), moment.T_start_robot);
        for (const Vector2d& at_m : moment.points_m) points_m.push_back(transform(T_now_then, at_m));
    }
    return points_m;
}

void LidarJudge::see_points(const pipeline::Step& step) {
    for (const ObstaclePoint& point : step.obstacles) {
        const Vector2d at_m = point.position_m.head<2>();
        const bool near = nearest_m(view_.high_m, at_m) <= tolerance_m(at_m.norm());
        score_.points_near.add(near);
        const Vector2d control_m = 1.5 * at_m;
        score_.control_near.add(nearest_m(view_.high_m, control_m) <= tolerance_m(control_m.norm()));
        if (point.moving) score_.moving_near.add(near);
        score_.near_by_range.at(band_of(at_m.norm())).add(near);
    }
}

void LidarJudge::see_cells(const std::vector<Vector2d>& now_m, const std::vector<Vector2d>& lately_m) {
    const auto is_found = [](const std::vector<Vector2d>& points_m, const Vector2d& cell_m) {
        return nearest_m(points_m, cell_m) <= tolerance_m(cell_m.norm());
    };
    for (const Vector2d& cell_m : view_.cells_m) {
        score_.cells_found.add(is_found(now_m, cell_m));
        score_.cells_lately.add(is_found(lately_m, cell_m));
        score_.found_by_range.at(band_of(cell_m.norm())).add(is_found(now_m, cell_m));
    }
    for (const auto& thing_m : things_of(view_.cells_m)) {
        const auto any = [&](const std::vector<Vector2d>& points_m) {
            return std::any_of(thing_m.begin(), thing_m.end(),
                               [&](const Vector2d& cell_m) { return is_found(points_m, cell_m); });
        };
        score_.things_found.add(any(now_m));
        score_.things_lately.add(any(lately_m));
    }
}

}  // namespace flownav::fidelity
