#include "flownav/nav/planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "cost_map.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using mrpt::maps::COccupancyGridMap2D;

constexpr std::array<std::array<int, 2>, 8> neighbours = {
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
constexpr float dear_factor = 1.5F;  // by which a short cut may be dearer than the path
constexpr float unreached = std::numeric_limits<float>::infinity();

struct Node {
    float estimate;  ///< cost of the whole way through here
    int index;

    /// The cheaper first; the older cell on ties, so that a plan does not depend on the queue.
    bool operator<(const Node& o) const {
        return estimate != o.estimate ? estimate > o.estimate : index > o.index;
    }
};

/// One search over a cost map.
class Search {
  public:
    Search(const CostMap& costs, const Vector2i& from, const Vector2i& goal)
        : costs_(costs),
          area_(costs.area()),
          goal_(goal),
          cost_(area_.size(), unreached),
          parent_(cost_.size(), -1),
          nearest_(index(from)) {
        reach(from, 0.0F, -1);
        run();
    }

    bool reached_goal() const { return cost_[index(goal_)] != unreached; }
    int end() const { return reached_goal() ? index(goal_) : nearest_; }
    float cost_of(int index) const { return cost_[index]; }

    std::vector<Vector2d> path() const {
        std::vector<Vector2d> path;
        for (int index = end(); index >= 0; index = parent_[index])
            path.push_back(area_.middle_of(cell(index)));
        std::reverse(path.begin(), path.end());
        return path;
    }

  private:
    Vector2i cell(int index) const { return area_.cell_at(static_cast<std::size_t>(index)); }
    int index(const Vector2i& at) const { return static_cast<int>(area_.index(at)); }

    float to_go_m(const Vector2i& from) const {
        return static_cast<float>((goal_ - from).cast<double>().norm() * area_.cell_m);
    }

    void reach(const Vector2i& at, float cost, int parent) {
        const int here = index(at);
        if (cost >= cost_[here]) return;
        cost_[here] = cost;
        parent_[here] = parent;
        queue_.push({cost + to_go_m(at), here});
        if (to_go_m(at) < to_go_m(cell(nearest_))) nearest_ = here;
    }

    void run() {
        while (!queue_.empty()) {
            const Node node = queue_.top();
            queue_.pop();
            const Vector2i at = cell(node.index);
            if (at == goal_) return;
            const float cost = cost_[node.index];
            if (node.estimate > cost + to_go_m(at)) continue;  // reached more cheaply since
            for (const auto& [dx, dy] : neighbours) expand(at, {dx, dy}, cost, node.index);
        }
    }

    void expand(const Vector2i& at, const Vector2i& step, float cost, int parent) {
        const Vector2i next = at + step;
        if (!area_.contains(next) || costs_.is_obstacle(next)) return;
        // Into closed ground only from closed ground: out of a tight place, never into one.
        if (costs_.is_closed(next) && !costs_.is_closed(at)) return;
        const double way_m = step.cast<double>().norm() * area_.cell_m;
        reach(next, cost + static_cast<float>(way_m) * (costs_.cost(at) + costs_.cost(next)) / 2, parent);
    }

    const CostMap& costs_;
    const GridArea& area_;
    Vector2i goal_;
    std::vector<float> cost_;
    std::vector<int> parent_;
    std::priority_queue<Node> queue_;
    int nearest_;
};

/// The dearest cell on a straight line.
float dearest(const CostMap& costs, const Vector2d& from_m, const Vector2d& to_m) {
    const double step_m = costs.area().cell_m / 2;
    const int steps = std::max(1, static_cast<int>(std::ceil((to_m - from_m).norm() / step_m)));
    float worst = 0.0F;
    for (int i = 1; i <= steps; ++i) {
        const Vector2d at_m = from_m + (to_m - from_m) * (static_cast<double>(i) / steps);
        worst = std::max(worst, costs.cost(costs.area().cell_of(at_m)));
    }
    return worst;
}

/// See Plan::way_point_m.
Vector2d way_point(const CostMap& costs, const std::vector<Vector2d>& path_m, const Vector2d& from_m,
                   const PlanParams& params) {
    Vector2d best = path_m.front();
    float dearest_of_path = costs.cost(costs.area().cell_of(from_m));
    double way_m = 0.0;
    for (std::size_t i = 1; i < path_m.size() && way_m < params.look_ahead_m; ++i) {
        way_m += (path_m[i] - path_m[i - 1]).norm();
        dearest_of_path = std::max(dearest_of_path, costs.cost(costs.area().cell_of(path_m[i])));
        const float allowed =
            std::min(dear_factor * dearest_of_path, std::max(dearest_of_path, CostMap::closed / 2));
        if (way_m <= params.look_near_m || dearest(costs, from_m, path_m[i]) <= allowed) best = path_m[i];
    }
    return best;
}

Plan plan_once(const COccupancyGridMap2D& map, const Vector2d& from_m, const Vector2d& goal_m,
               const RobotModel& robot, const PlanParams& params) {
    const GridArea area = area_around(map, from_m, goal_m, params);
    const CostMap costs(map, area, robot, params);
    const Vector2i from = area.cell_of(from_m);
    const Vector2i goal =
        area.cell_of(goal_m).cwiseMax(0).cwiseMin(Vector2i(area.columns - 1, area.rows - 1));
    const Search search(costs, from, goal);
    Plan result;
    result.path_m = search.path();
    result.cost_m = search.cost_of(search.end());
    result.way_point_m = way_point(costs, result.path_m, from_m, params);
    result.reaches_goal = search.reached_goal();
    return result;
}

}  // namespace

double inscribed_radius_m(const Polygon& footprint) {
    return std::max(0.0, -signed_distance_m(footprint, Vector2d::Zero()));
}

double length_m(const std::vector<Vector2d>& path_m) {
    double length = 0.0;
    for (std::size_t i = 1; i < path_m.size(); ++i) length += (path_m[i] - path_m[i - 1]).norm();
    return length;
}

Plan plan(const COccupancyGridMap2D& map, const Vector2d& from_m, const Vector2d& goal_m,
          const RobotModel& robot, const PlanParams& params) {
    const Plan wanted = plan_once(map, from_m, goal_m, robot, params);
    if (wanted.reaches_goal) {
        // What single sights closed is looked at from near before the robot drives far around it.
        const double least_cost_m = (wanted.path_m.back() - wanted.path_m.front()).norm();  // of any way
        if (wanted.cost_m <= least_cost_m + params.doubt_cost_m) return wanted;
        PlanParams doubting = params;
        doubting.limits.plan_obstacle_below = params.limits.plan_certain_below;
        const Plan straight = plan_once(map, from_m, goal_m, robot, doubting);
        return wanted.cost_m > straight.cost_m + params.doubt_cost_m ? straight : wanted;
    }
    // A single false point may close a passage: less margin, and then only what was seen again and again.
    PlanParams bold = params;
    bold.margin_m = params.bold_margin_m;
    for (const double below : {params.limits.plan_obstacle_below, params.limits.plan_certain_below}) {
        bold.limits.plan_obstacle_below = below;
        const Plan other = plan_once(map, from_m, goal_m, robot, bold);
        if (other.reaches_goal) return other;
    }
    return wanted;
}

}  // namespace flownav::nav
