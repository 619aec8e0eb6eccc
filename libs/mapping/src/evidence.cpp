#include "evidence.h"

#include <algorithm>

namespace flownav {
namespace {

using Eigen::Vector2d;

constexpr double seen_obstacle = 0.36;  // by a point that is surely in its cell; two cycles make it occupied
constexpr double seen_floor = 0.57;  // weaker: a block of floor before a thin leg says little about the leg

/// A point whose range is uncertain by more than half a cell says less about that one cell.
double p_free(const ObstaclePoint& point, double cell_m) {
    const double share = std::min(1.0, cell_m / 2 / std::max(point.sigma_m, 1e-6));
    return 0.5 - (0.5 - seen_obstacle) * share * share;
}

/// Number of steps that leave out no cell.
int steps_over(double way_m, double cell_m) {
    return static_cast<int>(way_m / (cell_m / 2));
}

double share(int i, int steps) {
    return steps > 0 ? static_cast<double>(i) / steps : 0.5;
}

void add_floor(const CellFrame& frame, const Vector2d& near, const Vector2d& far, double width_m,
               std::vector<Evidence>& evidence) {
    const Vector2d along = far - near;
    const Vector2d across = Vector2d(-along.y(), along.x()).normalized() * width_m;
    const int steps = steps_over(along.norm(), frame.cell_m);
    const int side_steps = steps_over(width_m, frame.cell_m);
    for (int i = 0; i <= steps; ++i) {
        for (int k = 0; k <= side_steps; ++k) {
            const Vector2d p = near + along * share(i, steps) + across * (share(k, side_steps) - 0.5);
            const Evidence floor{frame.cell_of(p), seen_floor};
            if (evidence.empty() || !(evidence.back() == floor)) evidence.push_back(floor);
        }
    }
}

}  // namespace

std::vector<Evidence> evidence_of(const ObstacleSet& set, const Pose2& T_frame_robot,
                                  const CellFrame& frame) {
    std::vector<Evidence> evidence;
    for (const ObstaclePoint& point : set.points) {
        if (point.moving) continue;
        const Vector2d p = transform(T_frame_robot, point.position_m.head<2>());
        evidence.push_back({frame.cell_of(p), p_free(point, frame.cell_m)});
    }
    for (const GroundPatch& patch : set.ground) {
        add_floor(frame, transform(T_frame_robot, patch.near_m), transform(T_frame_robot, patch.far_m),
                  patch.width_m, evidence);
    }
    std::sort(evidence.begin(), evidence.end());
    evidence.erase(std::unique(evidence.begin(), evidence.end()), evidence.end());
    return evidence;
}

}  // namespace flownav
