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

// Of being FREE, in thousandths. Limits the evidence for free ground, so that two or three sights of an
// obstacle make it occupied.
constexpr int log_odds_max = 800;

int thousandths(double p_free) {
    return static_cast<int>(std::lround(1000.0 * std::log(p_free / (1.0 - p_free))));
}

float probability(int log_odds) {
    if (log_odds == 0) return 0.5F;  // as most cells
    return static_cast<float>(1.0 / (1.0 + std::exp(-1e-3 * log_odds)));
}

/// Side of the rolling grid: a power of two, which wraps fastest.
int side_of(const MapParams& params) {
    // Holds the local map at any heading, and the evidence just outside it.
    const double wanted = 1.6 * params.size_m / params.resolution_m;
    int side = 1;
    while (side < wanted) side *= 2;
    return side;
}

/// True when the cells around the pose fit an int. False for NaN.
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
      cells_({Vector2d::Zero(), params.resolution_m}, side_of(params)),
      rims_(params.resolution_m),
      grid_(static_cast<float>(-params.size_m / 2), static_cast<float>(params.size_m / 2),
            static_cast<float>(-params.size_m / 2), static_cast<float>(params.size_m / 2),
            static_cast<float>(params.resolution_m)) {}

void LocalMap::insert(const ObstacleSet& set) {
    if (!has_cell(set.T_map_robot)) return;
    while (!history_.empty() && set.timestamp_s - history_.front().timestamp_s > params_.memory_s) {
        forget(history_.front());
        history_.pop();
    }
    const GridFrame& frame = cells_.frame();
    const Vector2i middle = frame.cell_of({set.T_map_robot.x_m, set.T_map_robot.y_m});
    gather_evidence(set, set.T_map_robot, frame, evidence_);
    rims_.note(set, frame, evidence_);
    Remembered& remembered = history_.push();
    remembered.timestamp_s = set.timestamp_s;
    remembered.number = ++sets_;
    remembered.entries.clear();
    for (const Evidence& e : evidence_) {
        if ((e.cell - middle).cwiseAbs().maxCoeff() >= cells_.side() / 2) continue;
        remembered.entries.push_back({e.cell, add(e), e.toward_unknown});
    }
    note_movers(set);
    redraw(set.T_map_robot);
}

/// Replaces the movers by those of a set, unless it holds a contact scan alone, which knows no movers.
void LocalMap::note_movers(const ObstacleSet& set) {
    if (set.points.empty() && set.ground.empty() && !is_empty(set)) return;
    movers_m_.clear();
    for (const ObstaclePoint& point : set.points) {
        if (point.moving) movers_m_.push_back(transform(set.T_map_robot, point.position_m.head<2>()));
    }
}

void LocalMap::redraw(const Pose2& T_map_robot) {
    if (!has_cell(T_map_robot)) return;
    const GridFrame& frame = cells_.frame();
    const int columns = static_cast<int>(grid_.getSizeX());
    const int rows = static_cast<int>(grid_.getSizeY());
    const Eigen::Isometry2d T = isometry(T_map_robot);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const Vector2d p = T * Vector2d(grid_.idx2x(x), grid_.idx2y(y));
            grid_.setCell(x, y, probability(log_odds(frame.cell_of(p))));
        }
    }
    // A rotated cell may contain no middle of a grid cell: draws occupied cells once more by their own
    // middle.
    const Eigen::Isometry2d T_robot_map = T.inverse();
    const GridArea of_robot = area_of(grid_);
    cells_.for_each([&](const Vector2i& cell, const Sum& sum) {
        if (sum.log_odds() >= 0) return;
        const Vector2i at = of_robot.cell_of(T_robot_map * frame.middle_of(cell));
        grid_.setCell(at.x(), at.y(), std::min(grid_.getCell(at.x(), at.y()), probability(sum.log_odds())));
    });
    draw_rims(T_robot_map);
    for (const Vector2d& mover_m : movers_m_) {
        const Vector2i at = of_robot.cell_of(T_robot_map * mover_m);
        grid_.updateCell(at.x(), at.y(), static_cast<float>(p_free_of_mover));
    }
}

/// Draws rims over all other evidence. The middle and four more points of a cell reach every cell of the
/// grid whose middle it covers, however it is rotated.
void LocalMap::draw_rims(const Eigen::Isometry2d& T_robot_map) {
    const GridArea of_robot = area_of(grid_);
    const double quarter_m = rims_.frame().cell_m / 4;
    for (const Rim& rim : rims_.rims()) {
        const Vector2d middle_m = rims_.frame().middle_of(rim.cell);
        for (const Vector2d& offset :
             {Vector2d(0, 0), Vector2d(1, 1), Vector2d(1, -1), Vector2d(-1, 1), Vector2d(-1, -1)}) {
            const Vector2i at = of_robot.cell_of(T_robot_map * Vector2d(middle_m + quarter_m * offset));
            grid_.setCell(at.x(), at.y(), static_cast<float>(p_free_of_rim));
        }
    }
}

int LocalMap::log_odds(const Vector2i& cell) const {
    const Sum* const sum = cells_.find(cell);
    return sum ? sum->log_odds() : 0;
}

int LocalMap::add(const Evidence& e) {
    Sum& sum = cells_.claim(e.cell, {0, 0, sets_});
    const int before = sum.log_odds();
    int after = before + thousandths(e.p_free);
    if (e.p_free > 0.5) {
        after = std::min(after, std::max(before, e.toward_unknown ? 0 : log_odds_max));
    } else if (e.toward_unknown) {
        after = std::max(after, std::min(before, 0));
    }
    add_to(sum, e.toward_unknown, after - before);
    return after - before;
}

/// Doubts may outlive what they doubted: they never tell anything themselves.
void LocalMap::add_to(Sum& sum, bool is_doubt, int log_odds) {
    (is_doubt ? sum.doubt : sum.told) += log_odds;
    sum.doubt = std::clamp(sum.doubt, -std::max(sum.told, 0), -std::min(sum.told, 0));
}

void LocalMap::forget(const Remembered& old) {
    for (const Entry& entry : old.entries) {
        Sum* const sum = cells_.find(entry.cell);
        // A cell that lost its place and claimed it again later does not hold this evidence.
        if (sum && sum->since <= old.number) add_to(*sum, entry.is_doubt, -entry.log_odds);
    }
}

}  // namespace flownav::mapping
