#include "flownav/mapping/local_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "evidence.h"
#include "flownav/mapping/grid_area.h"

namespace flownav::mapping {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

// Of being FREE, in thousandths: what was seen to be free for long becomes occupied after two or three sights
// too.
constexpr int log_odds_max = 800;

int thousandths(double p_free) {
    return static_cast<int>(std::lround(1000.0 * std::log(p_free / (1.0 - p_free))));
}

float probability(int log_odds) {
    if (log_odds == 0) return 0.5F;  // as most cells
    return static_cast<float>(1.0 / (1.0 + std::exp(-1e-3 * log_odds)));
}

/// A power of two, so that wrapping an index is a matter of its last bits.
int side_of(const MapParams& params) {
    // A turned square and the evidence just outside it must not meet themselves in the ring.
    const double wanted = 1.6 * params.size_m / params.resolution_m;
    int side = 1;
    while (side < wanted) side *= 2;
    return side;
}

/// True when the pose lies where cells have numbers. False for NaN.
bool has_cell(const Pose2& pose) {
    constexpr double far_m = 1e6;
    return std::abs(pose.x_m) < far_m && std::abs(pose.y_m) < far_m && std::isfinite(pose.yaw_rad);
}

Eigen::Isometry2d isometry(const Pose2& pose) {
    return Eigen::Translation2d(pose.x_m, pose.y_m) * Eigen::Rotation2Dd(pose.yaw_rad);
}

}  // namespace

LocalMap::LocalMap(const MapParams& params)
    : params_(params),
      side_(side_of(params)),
      cells_(static_cast<std::size_t>(side_) * side_),
      grid_(static_cast<float>(-params.size_m / 2), static_cast<float>(params.size_m / 2),
            static_cast<float>(-params.size_m / 2), static_cast<float>(params.size_m / 2),
            static_cast<float>(params.resolution_m)) {}

void LocalMap::insert(const ObstacleSet& set) {
    if (!has_cell(set.T_map_robot)) return;
    while (!history_.empty() && set.timestamp_s - history_.front().timestamp_s > params_.memory_s) {
        forget(history_.front());
        history_.pop();
    }
    const GridFrame frame{Vector2d::Zero(), params_.resolution_m};
    const Vector2i middle = frame.cell_of({set.T_map_robot.x_m, set.T_map_robot.y_m});
    gather_evidence(set, set.T_map_robot, frame, evidence_);
    Remembered& remembered = history_.push();
    remembered.timestamp_s = set.timestamp_s;
    remembered.number = ++sets_;
    remembered.entries.clear();
    for (const Evidence& e : evidence_) {
        if ((e.cell - middle).cwiseAbs().maxCoeff() >= side_ / 2) continue;
        remembered.entries.push_back({e.cell, add({e.cell, thousandths(e.p_free)})});
    }
    movers_m_.clear();
    for (const ObstaclePoint& point : set.points) {
        if (point.moving) movers_m_.push_back(transform(set.T_map_robot, point.position_m.head<2>()));
    }
    redraw(set.T_map_robot);
}

void LocalMap::redraw(const Pose2& T_map_robot) {
    if (!has_cell(T_map_robot)) return;
    const GridFrame frame{Vector2d::Zero(), params_.resolution_m};
    const int columns = static_cast<int>(grid_.getSizeX());
    const int rows = static_cast<int>(grid_.getSizeY());
    const Eigen::Isometry2d T = isometry(T_map_robot);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const Vector2d p = T * Vector2d(grid_.idx2x(x), grid_.idx2y(y));
            grid_.setCell(x, y, probability(log_odds(frame.cell_of(p))));
        }
    }
    // A cell that is askew may miss every middle of the grid: obstacles must not get lost.
    const Eigen::Isometry2d T_robot_map = T.inverse();
    const GridArea of_robot = area_of(grid_);
    for (const Cell& cell : cells_) {
        if (cell.log_odds >= 0) continue;
        const Vector2i at = of_robot.cell_of(T_robot_map * frame.middle_of(cell.index));
        grid_.setCell(at.x(), at.y(), std::min(grid_.getCell(at.x(), at.y()), probability(cell.log_odds)));
    }
    for (const Vector2d& mover_m : movers_m_) {
        const Vector2i at = of_robot.cell_of(T_robot_map * mover_m);
        grid_.updateCell(at.x(), at.y(), static_cast<float>(p_free_of_mover));
    }
}

std::size_t LocalMap::place_of(const Vector2i& index) const {
    const int last = side_ - 1;
    return static_cast<std::size_t>(index.y() & last) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(index.x() & last);
}

LocalMap::Cell& LocalMap::place(const Vector2i& index) {
    return cells_[place_of(index)];
}

int LocalMap::log_odds(const Vector2i& index) const {
    const Cell& cell = cells_[place_of(index)];
    return cell.index == index ? cell.log_odds : 0;
}

int LocalMap::add(const Entry& entry) {
    Cell& cell = place(entry.index);
    if (cell.index != entry.index) cell = {entry.index, 0, sets_};
    const int before = cell.log_odds;
    cell.log_odds = std::min(before + entry.log_odds, std::max(before, log_odds_max));
    return cell.log_odds - before;
}

void LocalMap::forget(const Remembered& old) {
    for (const Entry& entry : old.entries) {
        Cell& cell = place(entry.index);
        // A cell that gave its place away and came back since knows nothing of it.
        if (cell.index == entry.index && cell.since <= old.number) cell.log_odds -= entry.log_odds;
    }
}

}  // namespace flownav::mapping
