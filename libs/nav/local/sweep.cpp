#include "sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact_rule.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double nearer_m = 0.004;  // smallest approach that counts: the tables sample the way coarsely

/// Distances of one cell to the footprint along the way.
struct Passage {
    double first_m = std::numeric_limits<double>::infinity();  ///< distance at the beginning
    double nearest_m = std::numeric_limits<double>::infinity();
    double nearest_way = 0.0;
    bool touched = false;
};

class Sweep {
  public:
    Sweep(const FootprintField& field, const GridArea& grid, const SweepParams& params)
        : field_(field),
          grid_(grid),
          params_(params),
          rule_{params.margin_m, nearer_m},
          passages_(grid.size()) {}

    void visit(double way, const Pose2& T_robot_there) {
        const Pose2 T_there_robot = inverse(T_robot_there);
        const int reach = static_cast<int>(std::ceil(field_.radius_m() / grid_.cell_m));
        const Eigen::Vector2i at = grid_.cell_of({T_robot_there.x_m, T_robot_there.y_m});
        for (int r = std::max(0, at.y() - reach); r <= std::min(grid_.rows - 1, at.y() + reach); ++r) {
            for (int c = std::max(0, at.x() - reach); c <= std::min(grid_.columns - 1, at.x() + reach); ++c) {
                pass(grid_.index({c, r}), way,
                     field_.distance_m(transform(T_there_robot, grid_.middle_of({c, r}))));
            }
        }
    }

    std::vector<LaneCell> cells() const {
        std::vector<LaneCell> cells;
        for (std::size_t i = 0; i < passages_.size(); ++i) {
            const Passage& p = passages_[i];
            if (!p.touched && !(p.nearest_m < field_.reach_m())) continue;
            if (rule_.is_ignored(p.first_m)) continue;
            const double gap = p.touched ? 0.0 : std::max(1.0, p.nearest_m / gap_unit_m);
            cells.push_back({static_cast<std::uint32_t>(i),
                             static_cast<std::uint16_t>(std::lround(p.nearest_way / params_.unit)),
                             static_cast<std::uint8_t>(std::min(255.0, gap))});
        }
        std::stable_sort(cells.begin(), cells.end(),
                         [](const LaneCell& a, const LaneCell& b) { return a.way < b.way; });
        return cells;
    }

  private:
    void pass(std::size_t index, double way, double distance_m) {
        Passage& p = passages_[index];
        if (way == 0.0) p.first_m = distance_m;
        if (p.touched) return;
        const bool touches = rule_.touches(p.first_m, distance_m);
        if (touches || distance_m < p.nearest_m - 1e-6) {
            p.nearest_m = distance_m;
            p.nearest_way = way;
        }
        p.touched = touches;
    }

    const FootprintField& field_;
    const GridArea& grid_;
    const SweepParams& params_;
    ContactRule rule_;
    std::vector<Passage> passages_;
};

}  // namespace

std::vector<LaneCell> sweep(const FootprintField& field, const GridArea& grid, const PoseOfWay& pose_of,
                            const SweepParams& params) {
    Sweep cells(field, grid, params);
    const int steps = std::max(1, static_cast<int>(std::ceil(params.end / params.step)));
    for (int i = 0; i <= steps; ++i) {
        const double way = params.end * i / steps;
        cells.visit(way, pose_of(way));
    }
    return cells.cells();
}

}  // namespace flownav::nav
