#include "flownav/sim/passable.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "flownav/math/grid2d.h"
#include "flownav/sim/ground.h"
#include "flownav/sim/plan_view.h"

namespace flownav::sim {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector2i;

constexpr double cell_m = 0.05;
constexpr double lowest_m = 0.02;

double distance_m(const Disc& disc, const Vector2d& p) {
    return (p - disc.centre_m).norm() - disc.radius_m;
}

double distance_m(const Polygon& polygon, const Vector2d& p) {
    return signed_distance_m(polygon, p);
}

AlignedBox2d extent(const PlanShape& shape) {
    AlignedBox2d box;
    if (const auto* disc = std::get_if<Disc>(&shape)) {
        box.extend(disc->centre_m - Vector2d::Constant(disc->radius_m));
        box.extend(disc->centre_m + Vector2d::Constant(disc->radius_m));
    } else {
        for (const Vector2d& corner : std::get<Polygon>(shape)) box.extend(corner);
    }
    return box;
}

/// Cells of the ground: where the middle of the disc may be.
class Ground {
  public:
    explicit Ground(const AlignedBox2d& area) {
        area_.origin_m = area.min();
        area_.cell_m = cell_m;
        area_.columns = static_cast<int>(area.sizes().x() / cell_m) + 1;
        area_.rows = static_cast<int>(area.sizes().y() / cell_m) + 1;
        open_.assign(area_.size(), true);
    }

    void block(const PlanShape& shape, double radius_m) {
        const AlignedBox2d box = extent(shape);
        const Vector2i last(area_.columns - 1, area_.rows - 1);
        const Vector2i from = area_.cell_of(box.min() - Vector2d::Constant(radius_m)).cwiseMax(0);
        const Vector2i to = area_.cell_of(box.max() + Vector2d::Constant(radius_m)).cwiseMin(last);
        for (int y = from.y(); y <= to.y(); ++y) {
            for (int x = from.x(); x <= to.x(); ++x) {
                const Vector2d middle = area_.middle_of({x, y});
                const double off_m = std::visit([&](const auto& s) { return distance_m(s, middle); }, shape);
                if (off_m < radius_m) open_[area_.index({x, y})] = false;
            }
        }
    }

    /// Whether open cells that share a side lead from one point to the other.
    bool connects(const Vector2d& a_m, const Vector2d& b_m) {
        std::vector<Vector2i> front;
        const auto enter = [&](const Vector2i& c) {
            if (!area_.contains(c) || !open_[area_.index(c)]) return;
            open_[area_.index(c)] = false;
            front.push_back(c);
        };
        const Vector2i goal = area_.cell_of(b_m);
        enter(area_.cell_of(a_m));
        while (!front.empty()) {
            const Vector2i at = front.back();
            front.pop_back();
            if (at == goal) return true;
            for (const Vector2i& by : {Vector2i(1, 0), Vector2i(-1, 0), Vector2i(0, 1), Vector2i(0, -1)})
                enter(at + by);
        }
        return false;
    }

  private:
    GridArea area_;
    std::vector<bool> open_;
};

}  // namespace

bool passable(const World& world, double radius_m, double height_m) {
    if (!world.goal) return false;
    const Vector2d start(world.start.x_m, world.start.y_m);
    AlignedBox2d area(start.cwiseMin(*world.goal), start.cwiseMax(*world.goal));
    std::vector<PlanShape> obstacles;
    for (const Solid& solid : world.solids) {
        if (!solid.solid || !solid.script.empty()) continue;
        const auto plan = plan_view(solid.shape, solid.T_world_solid, lowest_m, height_m);
        if (!plan) continue;
        obstacles.push_back(*plan);
        area.extend(extent(*plan));
    }
    for (const GroundWall& wall : ground_walls(world)) {
        if (std::max(wall.left_rise_m, wall.right_rise_m) <= step_max_m) continue;
        obstacles.emplace_back(Polygon{wall.left_m.head<2>(), wall.right_m.head<2>()});
        area.extend(extent(obstacles.back()));
    }
    const Vector2d around = Vector2d::Constant(2 * radius_m + 2 * cell_m);
    Ground ground({area.min() - around, area.max() + around});
    for (const PlanShape& obstacle : obstacles) ground.block(obstacle, radius_m);
    return ground.connects(start, *world.goal);
}

}  // namespace flownav::sim
