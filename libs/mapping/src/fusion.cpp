#include "flownav/mapping/fusion.h"

#include <algorithm>
#include <cmath>

#include "evidence.h"

namespace flownav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

constexpr double margin_m = 2.0;         // by which a growing grid grows ahead
constexpr double extent_max_m = 2000.0;  // of a drive's map: a broken odometry must not eat the memory

/// Grows the grid so that it holds everything the set saw.
void make_room(COccupancyGridMap2D& grid, const ObstacleSet& set) {
    const auto bounded = [](const Vector2d& p) -> Vector2d {
        return p.cwiseMax(-extent_max_m / 2).cwiseMin(extent_max_m / 2);
    };
    Vector2d low = bounded({set.T_map_robot.x_m, set.T_map_robot.y_m});
    Vector2d high = low;
    const auto include = [&](const Vector2d& p_robot) {
        const Vector2d p = bounded(transform(set.T_map_robot, p_robot));
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    };
    for (const ObstaclePoint& point : set.points) include(point.position_m.head<2>());
    for (const GroundPatch& patch : set.ground) include(patch.far_m);
    const auto beyond = [](double wanted, double has, double sign) {
        return static_cast<float>(sign * (wanted - has) > 0 ? wanted + sign * margin_m : has);
    };
    grid.resizeGrid(beyond(low.x(), grid.getXMin(), -1), beyond(high.x(), grid.getXMax(), 1),
                    beyond(low.y(), grid.getYMin(), -1), beyond(high.y(), grid.getYMax(), 1), 0.5F, false);
}

}  // namespace

DriveMap::DriveMap(const MapParams& params)
    : grid_(-static_cast<float>(margin_m), static_cast<float>(margin_m), -static_cast<float>(margin_m),
            static_cast<float>(margin_m), static_cast<float>(params.resolution_m)) {}

void DriveMap::insert(const ObstacleSet& set) {
    make_room(grid_, set);
    const CellFrame frame{{grid_.getXMin(), grid_.getYMin()}, grid_.getResolution()};
    gather_evidence(set, set.T_map_robot, frame, evidence_);
    for (const Evidence& e : evidence_)
        grid_.updateCell(e.cell.x(), e.cell.y(), static_cast<float>(e.p_free));
}

}  // namespace flownav
