#include "flownav/mapping/fusion.h"

#include <algorithm>
#include <cmath>

namespace flownav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

// MRPT's cells speak of the probability of being FREE.
constexpr double seen_obstacle = 0.36;  // by a point that is surely in its cell; two cycles make it occupied
constexpr double seen_mover = 0.2;      // it will be elsewhere in the next cycle: one must do
constexpr double seen_floor = 0.57;  // weaker: a block of floor before a thin leg says little about the leg
constexpr double margin_m = 2.0;     // by which a growing grid grows ahead
constexpr double extent_max_m = 2000.0;  // of a drive's map: a broken odometry must not eat the memory

/// What one set says about one cell. A cell hears of each set once, however many vectors fell into it.
struct Evidence {
    int cell_x, cell_y;
    double p_free;

    bool operator<(const Evidence& o) const {
        if (cell_x != o.cell_x) return cell_x < o.cell_x;
        if (cell_y != o.cell_y) return cell_y < o.cell_y;
        return p_free < o.p_free;  // the surest obstacle first: it wins over floor in the same cell
    }
    bool operator==(const Evidence& o) const { return cell_x == o.cell_x && cell_y == o.cell_y; }
};

/// A point whose range is uncertain by more than half a cell says less about that one cell.
double p_free(const ObstaclePoint& point, double resolution_m) {
    if (point.moving) return seen_mover;
    const double share = std::min(1.0, resolution_m / 2 / std::max(point.sigma_m, 1e-6));
    return 0.5 - (0.5 - seen_obstacle) * share * share;
}

void add_floor(const COccupancyGridMap2D& grid, const Vector2d& near, const Vector2d& far,
               std::vector<Evidence>& evidence) {
    const double step = grid.getResolution() / 2;
    const int steps = static_cast<int>((far - near).norm() / step);
    for (int i = 0; i <= steps; ++i) {
        const Vector2d p = near + (far - near) * (steps > 0 ? static_cast<double>(i) / steps : 0.0);
        evidence.push_back({grid.x2idx(p.x()), grid.y2idx(p.y()), seen_floor});
    }
}

enum class Movers { LeaveOut, Insert };

/// Fuses a set that was seen from T_grid_robot, in the frame of the grid. Cells outside the grid are left
/// out.
void fuse(COccupancyGridMap2D& grid, const ObstacleSet& set, const Pose2& T_grid_robot, Movers movers) {
    std::vector<Evidence> evidence;
    for (const ObstaclePoint& point : set.points) {
        if (point.moving && movers == Movers::LeaveOut) continue;
        const Vector2d p = transform(T_grid_robot, point.position_m.head<2>());
        evidence.push_back({grid.x2idx(p.x()), grid.y2idx(p.y()), p_free(point, grid.getResolution())});
    }
    for (const GroundPatch& patch : set.ground) {
        add_floor(grid, transform(T_grid_robot, patch.near_m), transform(T_grid_robot, patch.far_m),
                  evidence);
    }
    std::sort(evidence.begin(), evidence.end());
    evidence.erase(std::unique(evidence.begin(), evidence.end()), evidence.end());
    for (const Evidence& e : evidence) grid.updateCell(e.cell_x, e.cell_y, static_cast<float>(e.p_free));
}

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
    fuse(grid_, set, set.T_map_robot, Movers::LeaveOut);
}

LocalMap::LocalMap(const MapParams& params)
    : params_(params),
      grid_(static_cast<float>(-params.size_m / 2), static_cast<float>(params.size_m / 2),
            static_cast<float>(-params.size_m / 2), static_cast<float>(params.size_m / 2),
            static_cast<float>(params.resolution_m)) {}

void LocalMap::insert(const ObstacleSet& set) {
    history_.push_back(set);
    while (set.timestamp_s - history_.front().timestamp_s > params_.memory_s) history_.pop_front();
    redraw(set.T_map_robot);
}

void LocalMap::redraw(const Pose2& T_map_robot) {
    grid_.fill(0.5F);
    const Pose2 T_robot_map = inverse(T_map_robot);
    for (const ObstacleSet& old : history_) {
        const bool newest = &old == &history_.back();
        fuse(grid_, old, compose(T_robot_map, old.T_map_robot), newest ? Movers::Insert : Movers::LeaveOut);
    }
}

}  // namespace flownav
