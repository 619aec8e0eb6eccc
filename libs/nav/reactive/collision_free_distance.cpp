#include "flownav/nav/collision_free_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "flownav/mapping/grid_area.h"
#include "flownav/nav/motion_model.h"
#include "local/contact_rule.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using mrpt::maps::COccupancyGridMap2D;

constexpr double still_mps = 0.01;  // slower is turning on the spot

class Walk {
  public:
    Walk(const FootprintField& field, const COccupancyGridMap2D& map, const CollisionFreeParams& params)
        : field_(field),
          area_(mapping::area_of(map)),
          params_(params),
          kinds_(kinds_of(map, params.limits)),
          counted_(kinds_.size(), 0),
          rule_{params.margin_m} {
        rule_ = rule_.beside(nearest_m());
    }

    /// Whether the footprint touches an obstacle there; counts the unseen cells it comes to cover.
    bool touches(const Pose2& T_robot_there, bool count_unseen) {
        const Pose2 T_there_robot = inverse(T_robot_there);
        const double radius_m = field_.radius_m() - field_.reach_m() + params_.margin_m;
        bool touches = false;
        for_cells_around({T_robot_there.x_m, T_robot_there.y_m}, radius_m, [&](const Vector2i& cell) {
            const CellKind kind = kind_of(cell);
            if (touches || kind == CellKind::Free || kind == CellKind::Weak) return;
            const Vector2d middle = area_.middle_of(cell);
            const double distance_m = field_.distance_m(transform(T_there_robot, middle));
            if (distance_m >= rule_.margin_m && distance_m >= 0.0) return;
            if (kind == CellKind::Occupied) {
                touches = rule_.touches(field_.distance_m(middle), distance_m);
            } else if (distance_m < 0.0) {
                count(cell, count_unseen);
            }
        });
        return touches;
    }

    bool unseen() const {
        return count_ > 0 && count_ * area_.cell_m * area_.cell_m >= params_.unseen_area_m2;
    }

  private:
    /// Cells within a radius about a point, and some in the corners of the square; also outside the map.
    template <class Visit>
    void for_cells_around(const Vector2d& p_robot, double radius_m, const Visit& visit) const {
        const int reach = static_cast<int>(std::ceil(radius_m / area_.cell_m));
        const Vector2i middle = area_.cell_of(p_robot);
        for (int row = middle.y() - reach; row <= middle.y() + reach; ++row)
            for (int column = middle.x() - reach; column <= middle.x() + reach; ++column)
                visit(Vector2i(column, row));
    }
    CellKind kind_of(const Vector2i& cell) const {
        return area_.contains(cell) ? kinds_[area_.index(cell)] : CellKind::Unknown;
    }

    /// Cells met before counting begins never count.
    void count(const Vector2i& cell, bool counts) {
        if (area_.contains(cell)) {
            if (counted_[area_.index(cell)]) return;
            counted_[area_.index(cell)] = 1;
        }
        if (counts) ++count_;
    }

    /// Distance of the footprint to the nearest obstacle now, at most the field's reach.
    double nearest_m() const {
        double least_m = field_.reach_m();
        for_cells_around(Vector2d::Zero(), field_.radius_m(), [&](const Vector2i& cell) {
            if (kind_of(cell) != CellKind::Occupied) return;
            const double distance_m = field_.distance_m(area_.middle_of(cell));
            if (!rule_.is_ignored(distance_m)) least_m = std::min(least_m, distance_m);
        });
        return least_m;
    }

    const FootprintField& field_;
    GridArea area_;
    const CollisionFreeParams& params_;
    std::vector<CellKind> kinds_;
    std::vector<std::uint8_t> counted_;
    int count_ = 0;
    ContactRule rule_;
};

}  // namespace

std::vector<CellKind> kinds_of(const COccupancyGridMap2D& map, const mapping::OccupancyLimits& limits) {
    using Cell = COccupancyGridMap2D::cellType;
    std::array<CellKind, 256> kind_of_value{};
    for (int value = -128; value < 128; ++value) {
        const double p = COccupancyGridMap2D::l2p(static_cast<Cell>(value));
        CellKind& kind = kind_of_value[static_cast<std::uint8_t>(value)];
        kind = p < limits.obstacle_below   ? CellKind::Occupied
               : p < limits.doubtful_below ? CellKind::Weak
               : p > limits.seen_above     ? CellKind::Free
                                           : CellKind::Unknown;
    }
    const auto columns = static_cast<std::size_t>(map.getSizeX());
    std::vector<CellKind> kinds(columns * map.getSizeY());
    for (std::size_t row = 0; row < map.getSizeY(); ++row) {
        const Cell* const cells = map.getRow(static_cast<int>(row));
        for (std::size_t column = 0; column < columns; ++column)
            kinds[row * columns + column] = kind_of_value[static_cast<std::uint8_t>(cells[column])];
    }
    return kinds;
}

CollisionFreeDistance collision_free_distance(const FootprintField& field, const COccupancyGridMap2D& map,
                                              const MotionCommand& command,
                                              const CollisionFreeParams& params) {
    const bool turning = std::abs(command.v_mps) < still_mps;
    const double end = turning ? M_PI : params.length_m;
    const double step = turning ? 0.04 : static_cast<double>(map.getResolution()) / 2;
    MotionCommand unit{0.0, command.omega_radps < 0.0 ? -1.0 : 1.0};
    if (!turning) {
        unit.v_mps = command.v_mps < 0.0 ? -1.0 : 1.0;
        unit.omega_radps = command.omega_radps / std::abs(command.v_mps);
    }
    Walk walk(field, map, params);
    CollisionFreeDistance way{end, end};
    for (int i = 0; i * step < end; ++i) {
        const double at = i * step;
        if (walk.touches(pose_after(unit, at), turning || at > params.bumper_m)) {
            way.occupied = at;
            break;
        }
        if (walk.unseen()) way.unseen = std::min(way.unseen, at);
    }
    way.unseen = std::min(way.unseen, way.occupied);
    return way;
}

}  // namespace flownav::nav
