#include "flownav/mapping/global_map.h"

#include <algorithm>
#include <cmath>

#include "contact_lines.h"
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
    const auto include = [&](const Vector2d& p_map) {
        const Vector2d p = bounded(p_map);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    };
    for (const ObstaclePoint& point : set.points)
        include(transform(set.T_map_robot, point.position_m.head<2>()));
    for (const GroundPatch& patch : set.ground) include(transform(set.T_map_robot, patch.far_m));
    for_each_contact(set.contacts, set.T_map_robot, grid.getResolution(),
                     [&](BeamCause, const Vector2d& p) { include(p); });
    const Eigen::AlignedBox2d floor = floor_bounds(set.contacts, set.T_map_robot, 0.0);
    if (!floor.isEmpty()) include(floor.min());
    if (!floor.isEmpty()) include(floor.max());
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
      rims_(params.resolution_m),
      grid_(-static_cast<float>(margin_m), static_cast<float>(margin_m), -static_cast<float>(margin_m),
            static_cast<float>(margin_m), static_cast<float>(params.resolution_m)) {}

void GlobalMap::insert(const ObstacleSet& set) {
    ++sets_;
    if (!(std::max(std::abs(set.T_map_robot.x_m), std::abs(set.T_map_robot.y_m)) <= half_m_)) {
        ++sets_outside_;
        return;
    }
    make_room(grid_, set, half_m_);
    const GridArea area = area_of(grid_);
    gather_evidence(set, set.T_map_robot, area, evidence_);
    rims_.note(set, area, evidence_);
    const auto set_cell = [&](const Vector2d& p_m, double p_free) {
        const Eigen::Vector2i cell = area.cell_of(p_m);
        grid_.setCell(cell.x(), cell.y(), static_cast<float>(p_free));
    };
    for (const Vector2d& p_m : rims_.removed_m()) set_cell(p_m, 0.5);
    for (const Evidence& e : evidence_) {
        const auto is_beyond_unknown = [&] {
            const float p_free = grid_.getCell(e.cell.x(), e.cell.y());
            return e.p_free > 0.5 ? p_free >= 0.5F : p_free <= 0.5F;
        };
        if (e.toward_unknown && is_beyond_unknown()) continue;
        grid_.updateCell(e.cell.x(), e.cell.y(), static_cast<float>(e.p_free));
        if (e.toward_unknown && is_beyond_unknown()) grid_.setCell(e.cell.x(), e.cell.y(), 0.5F);
    }
    for (const Rim& rim : rims_.rims()) set_cell(rims_.frame().middle_of(rim.cell), p_free_of_rim);
}

}  // namespace flownav::mapping
