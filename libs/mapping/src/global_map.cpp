#include "flownav/mapping/global_map.h"

#include <algorithm>
#include <cmath>

#include "evidence.h"
#include "flownav/mapping/grid_area.h"

namespace flownav::mapping {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

constexpr double margin_m = 2.0;         // by which a growing grid grows ahead
constexpr double extent_max_m = 2000.0;  // edge of the largest map, and
constexpr double cells_max = 20000.0;    // the same in cells: MRPT counts the cells of a map in 32 bits

/// Grows the grid so that it holds everything the set saw within `half_m` of the start.
void make_room(COccupancyGridMap2D& grid, const ObstacleSet& set, double half_m) {
    const auto bounded = [half_m](const Vector2d& p) -> Vector2d {
        return p.cwiseMax(-half_m).cwiseMin(half_m);
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
    const auto beyond = [half_m](double wanted, double has, double sign) {
        const double grown = sign * std::min(sign * wanted + margin_m, half_m);
        return static_cast<float>(sign * (wanted - has) > 0 ? grown : has);
    };
    grid.resizeGrid(beyond(low.x(), grid.getXMin(), -1), beyond(high.x(), grid.getXMax(), 1),
                    beyond(low.y(), grid.getYMin(), -1), beyond(high.y(), grid.getYMax(), 1), 0.5F, false);
}

}  // namespace

GlobalMap::GlobalMap(const MapParams& params)
    : half_m_(std::min(extent_max_m, cells_max * params.resolution_m) / 2),
      grid_(-static_cast<float>(margin_m), static_cast<float>(margin_m), -static_cast<float>(margin_m),
            static_cast<float>(margin_m), static_cast<float>(params.resolution_m)) {}

void GlobalMap::insert(const ObstacleSet& set) {
    ++sets_;
    if (!(std::max(std::abs(set.T_map_robot.x_m), std::abs(set.T_map_robot.y_m)) <= half_m_)) {
        ++sets_outside_;
        return;
    }
    make_room(grid_, set, half_m_);
    gather_evidence(set, set.T_map_robot, area_of(grid_), evidence_);
    for (const Evidence& e : evidence_)
        grid_.updateCell(e.cell.x(), e.cell.y(), static_cast<float>(e.p_free));
}

}  // namespace flownav::mapping
