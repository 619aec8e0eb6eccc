#include "flownav/nav/free_way.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "flownav/nav/motion_model.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

constexpr double nearer_m = 0.003;  // accuracy of the footprint's raster
constexpr double least_margin_m = 0.02;
constexpr double under_m = 0.06;
constexpr double still_mps = 0.01;  // slower is turning on the spot

class Walk {
  public:
    Walk(const FootprintField& field, const COccupancyGridMap2D& map, const FreeWayParams& params)
        : field_(field),
          map_(map),
          params_(params),
          kinds_(kinds_of(map, params.limits)),
          counted_(kinds_.size(), 0),
          margin_m_(params.margin_m) {
        margin_m_ = std::min(margin_m_, std::max(least_margin_m, nearest_m() - nearer_m));
    }

    /// Whether the footprint touches an obstacle there; counts the unseen cells it comes to cover.
    bool touches(const Pose2& T_robot_there, bool count_unseen) {
        const Pose2 T_there_robot = inverse(T_robot_there);
        const double cell_m = map_.getResolution();
        const double radius_m = field_.radius_m() - field_.reach_m() + params_.margin_m;
        const int reach = static_cast<int>(std::ceil(radius_m / cell_m));
        const int column = map_.x2idx(T_robot_there.x_m);
        const int row = map_.y2idx(T_robot_there.y_m);
        for (int r = row - reach; r <= row + reach; ++r) {
            for (int c = column - reach; c <= column + reach; ++c) {
                const CellKind kind = kind_of(c, r);
                if (kind == CellKind::Free || kind == CellKind::Weak) continue;
                const Vector2d middle(map_.idx2x(c), map_.idx2y(r));
                const double distance_m = field_.distance_m(transform(T_there_robot, middle));
                if (distance_m >= margin_m_ && distance_m >= 0.0) continue;
                if (kind == CellKind::Occupied) {
                    if (comes_nearer(middle, distance_m)) return true;
                } else if (distance_m < 0.0) {
                    count(c, r, count_unseen);
                }
            }
        }
        return false;
    }

    bool unseen() const {
        const double cell_m = map_.getResolution();
        return count_ > 0 && count_ * cell_m * cell_m >= params_.unseen_area_m2;
    }

  private:
    bool inside(int column, int row) const {
        return column >= 0 && row >= 0 && column < static_cast<int>(map_.getSizeX()) &&
               row < static_cast<int>(map_.getSizeY());
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * map_.getSizeX() + static_cast<std::size_t>(column);
    }
    CellKind kind_of(int column, int row) const {
        return inside(column, row) ? kinds_[index(column, row)] : CellKind::Unknown;
    }

    bool comes_nearer(const Vector2d& p_robot, double distance_m) const {
        const double first_m = field_.distance_m(p_robot);
        return first_m > -under_m && distance_m < first_m - nearer_m;
    }

    /// Cells met before counting begins never count.
    void count(int column, int row, bool counts) {
        if (inside(column, row)) {
            if (counted_[index(column, row)]) return;
            counted_[index(column, row)] = 1;
        }
        if (counts) ++count_;
    }

    /// Distance of the footprint to the nearest obstacle now, at most the field's reach.
    double nearest_m() const {
        double least_m = field_.reach_m();
        const int reach = static_cast<int>(std::ceil(field_.radius_m() / map_.getResolution()));
        const int column = map_.x2idx(0.0);
        const int row = map_.y2idx(0.0);
        for (int r = row - reach; r <= row + reach; ++r) {
            for (int c = column - reach; c <= column + reach; ++c) {
                if (kind_of(c, r) != CellKind::Occupied) continue;
                const double distance_m = field_.distance_m({map_.idx2x(c), map_.idx2y(r)});
                if (distance_m > -under_m) least_m = std::min(least_m, distance_m);
            }
        }
        return least_m;
    }

    const FootprintField& field_;
    const COccupancyGridMap2D& map_;
    const FreeWayParams& params_;
    std::vector<CellKind> kinds_;
    std::vector<std::uint8_t> counted_;
    int count_ = 0;
    double margin_m_;  ///< less where something stands nearer already
};

}  // namespace

std::vector<CellKind> kinds_of(const COccupancyGridMap2D& map, const CellLimits& limits) {
    using Cell = COccupancyGridMap2D::cellType;
    std::array<CellKind, 256> kind_of_value{};
    for (int value = -128; value < 128; ++value) {
        const double p = COccupancyGridMap2D::l2p(static_cast<Cell>(value));
        CellKind& kind = kind_of_value[static_cast<std::uint8_t>(value)];
        kind = p < limits.occupied ? CellKind::Occupied
               : p < limits.weak   ? CellKind::Weak
               : p > limits.seen   ? CellKind::Free
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

FreeWay free_way(const FootprintField& field, const COccupancyGridMap2D& map, const MotionCommand& command,
                 const FreeWayParams& params) {
    const bool turning = std::abs(command.v_mps) < still_mps;
    const double end = turning ? M_PI : params.length_m;
    const double step = turning ? 0.04 : static_cast<double>(map.getResolution()) / 2;
    MotionCommand unit{0.0, command.omega_radps < 0.0 ? -1.0 : 1.0};
    if (!turning) {
        unit.v_mps = command.v_mps < 0.0 ? -1.0 : 1.0;
        unit.omega_radps = command.omega_radps / std::abs(command.v_mps);
    }
    Walk walk(field, map, params);
    FreeWay way{end, end};
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
