#include "cost_map.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/mapping/grid_area.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using mrpt::maps::COccupancyGridMap2D;

/// Probability of being FREE of every cell of the area.
cv::Mat probabilities(const COccupancyGridMap2D& map, const GridArea& area) {
    cv::Mat p_free(area.rows, area.columns, CV_32F);
    const Vector2i first = mapping::area_of(map).cell_of(area.middle_of({0, 0}));
    for (int row = 0; row < area.rows; ++row) {
        float* const line = p_free.ptr<float>(row);
        for (int column = 0; column < area.columns; ++column)
            line[column] = map.getCell(first.x() + column, first.y() + row);
    }
    return p_free;
}

float cost_of(float p_free, double distance_m, double closed_m, const PlanParams& params) {
    if (p_free < params.limits.plan_obstacle_below) return CostMap::obstacle;
    if (distance_m < closed_m) return CostMap::closed;
    double cost = 1.0;
    const double tightness = std::max(0.0, 1.0 - (distance_m - closed_m) / params.comfort_m);
    cost += params.comfort_cost * tightness * tightness;
    // Every bit of evidence for free ground makes it cheaper.
    const double unseen = std::clamp((0.7 - p_free) / 0.2, 0.0, 1.0);
    return static_cast<float>(cost + params.unknown_cost * unseen);
}

/// Makes the places to avoid dearer.
void add_avoidance(const GridArea& area, const PlanParams& params, cv::Mat& cost) {
    const int reach = static_cast<int>(std::ceil(params.avoid_radius_m / area.cell_m));
    for (const Vector2d& place_m : params.avoid_m) {
        const Vector2i middle = area.cell_of(place_m);
        for (int dy = -reach; dy <= reach; ++dy) {
            for (int dx = -reach; dx <= reach; ++dx) {
                const Vector2i cell = middle + Vector2i(dx, dy);
                const bool near = (area.middle_of(cell) - place_m).norm() < params.avoid_radius_m;
                if (!near || !area.contains(cell)) continue;
                float& value = cost.at<float>(cell.y(), cell.x());
                if (value >= CostMap::closed) continue;
                value = std::min(value + static_cast<float>(params.avoid_cost), CostMap::closed - 1.0F);
            }
        }
    }
}

}  // namespace

CostMap::CostMap(const COccupancyGridMap2D& map, const GridArea& area, const RobotModel& robot,
                 const PlanParams& params)
    : area_(area), cost_(area.rows, area.columns, CV_32F) {
    const cv::Mat p_free = probabilities(map, area);
    const cv::Mat open = p_free >= params.limits.plan_obstacle_below;
    cv::Mat distance_cells;
    cv::distanceTransform(open, distance_cells, cv::DIST_L2, cv::DIST_MASK_5);
    const double closed_m = inscribed_radius_m(robot.footprint_m) + params.margin_m;
    for (int row = 0; row < area.rows; ++row) {
        for (int column = 0; column < area.columns; ++column) {
            const double distance_m = distance_cells.at<float>(row, column) * area.cell_m;
            cost_.at<float>(row, column) =
                cost_of(p_free.at<float>(row, column), distance_m, closed_m, params);
        }
    }
    add_avoidance(area_, params, cost_);
}

GridArea area_around(const COccupancyGridMap2D& map, const Vector2d& from_m, const Vector2d& goal_m,
                     const PlanParams& params) {
    const Vector2d margin = Vector2d::Constant(params.area_margin_m);
    const Vector2d half = Vector2d::Constant(params.area_max_m / 2);
    Vector2d low = from_m.cwiseMin(goal_m) - margin;
    Vector2d high = from_m.cwiseMax(goal_m) + margin;
    low = low.cwiseMin(Vector2d(map.getXMin(), map.getYMin())).cwiseMax(from_m - half);
    high = high.cwiseMax(Vector2d(map.getXMax(), map.getYMax())).cwiseMin(from_m + half);
    GridArea area;
    area.cell_m = map.getResolution();
    // On the cells of the map, so that both have the same edges.
    const Vector2d map_origin(map.getXMin(), map.getYMin());
    const Vector2i first = ((low - map_origin) / area.cell_m).array().floor().cast<int>();
    const Vector2i last = ((high - map_origin) / area.cell_m).array().ceil().cast<int>();
    area.origin_m = map_origin + first.cast<double>() * area.cell_m;
    area.columns = last.x() - first.x();
    area.rows = last.y() - first.y();
    return area;
}

}  // namespace flownav::nav
