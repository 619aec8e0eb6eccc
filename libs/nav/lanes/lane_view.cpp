#include "lane_view.h"

#include <algorithm>
#include <cmath>

#include "flownav/nav/motion_model.h"
#include "turning.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double unit_m = 0.001;     // unit of LaneCell::way
constexpr double moving_mps = 0.05;  // at lower speeds the curvature is ignored
constexpr double turning_radps = 0.1;
// Reduction of LaneView::sure by one uncertain cell at the start of the lane.
constexpr double weak_share = 0.03;
constexpr double away_m = 0.8;  // distance equivalent to pointing straight away from the way point

/// Pose after `way_m` along a lane, in the robot's frame.
Pose2 end_of(const LaneView& lane, double way_m) {
    const Pose2 turned{0.0, 0.0, lane.heading_rad};
    return compose(turned, pose_after({1.0, lane.curvature_1pm}, way_m));
}

/// Distance along an arc to its point nearest to `point_m`, within 0..end_m.
double nearest_way_m(const LaneView& lane, const Vector2d& point_m, double end_m) {
    const Vector2d p = transform(Pose2{0.0, 0.0, -lane.heading_rad}, point_m);
    const double kappa = lane.curvature_1pm;
    if (std::abs(kappa) < 1e-6) return std::clamp(p.x(), 0.0, end_m);
    const double radius_m = 1.0 / kappa;
    // Angle covered about the centre of the circle, in the direction of driving.
    double angle = std::atan2(p.x(), std::abs(radius_m) - std::copysign(1.0, kappa) * p.y());
    const double end_rad = end_m * std::abs(kappa);
    // A point behind the start is nearest to the start or the end, whichever comes first along the circle.
    if (angle < 0.0) angle += 2.0 * M_PI;
    if (angle > end_rad) angle = angle - end_rad < 2.0 * M_PI - angle ? end_rad : 0.0;
    return angle / std::abs(kappa);
}

}  // namespace

LaneView look_along(const LaneTables& tables, const Lane& lane, const std::vector<CellKind>& kinds,
                    const LaneParams& params) {
    LaneView view;
    view.curvature_1pm = lane.curvature_1pm;
    view.heading_rad = lane.heading_rad;
    view.free_m = view.unseen_m = lane.length_m;
    const double cell_m2 = tables.grid.cell_m * tables.grid.cell_m;
    const int unseen_limit = std::max(1, static_cast<int>(std::ceil(params.unseen_area_m2 / cell_m2)));
    int gap = static_cast<int>(tables.layout.side_m / gap_unit_m);
    int swept = 0;
    int unseen_near = 0;
    int unseen = 0;
    for (const LaneCell& cell : lane.cells) {
        const CellKind kind = kinds[cell.index];
        const double way_m = cell.way * unit_m;
        const bool is_near = way_m < params.horizon_m;
        if (cell.gap == 0 && is_near) ++swept;
        if (kind == CellKind::Free) continue;
        if (cell.gap > 0) {
            if (kind == CellKind::Occupied && is_near) gap = std::min<int>(gap, cell.gap);
        } else if (kind == CellKind::Occupied) {
            view.free_m = way_m;
            break;
        } else if (kind == CellKind::Weak) {
            view.sure -= weak_share * std::max(0.0, 1.0 - way_m / params.horizon_m);
        } else {
            if (is_near) ++unseen_near;
            if (way_m > params.bumper_m && ++unseen == unseen_limit) view.unseen_m = way_m;
        }
    }
    view.unseen_m = std::min(view.unseen_m, view.free_m);
    view.gap_m = gap * gap_unit_m;
    view.sure = std::max(0.0, view.sure);
    view.seen = swept > 0 ? 1.0 - static_cast<double>(unseen_near) / swept : 1.0;
    return view;
}

double nearness(const LaneView& view, const Vector2d& waypoint_m, const LaneParams& params) {
    const double distance_m = std::max(0.05, waypoint_m.norm());
    const double usable_m = std::clamp(view.free_m - params.standoff_m, 0.0, params.horizon_m);
    const double way_m = nearest_way_m(view, waypoint_m, usable_m);
    const Vector2d left = transform(inverse(end_of(view, way_m)), waypoint_m);
    const double away = left.norm() > 0.1 ? (1.0 - std::cos(bearing_rad(left))) / 2 : 0.0;
    const double rest_m = left.norm() + params.away_m * away;
    return (distance_m - rest_m) / std::min(distance_m, params.horizon_m);
}

double free_turn_rad(const std::vector<LaneCell>& turn, const std::vector<CellKind>& kinds) {
    for (const LaneCell& cell : turn)
        if (cell.gap == 0 && kinds[cell.index] == CellKind::Occupied) return cell.way * unit_m;
    return M_PI;
}

double score(const LaneTables& tables, const LaneView& view, const MotionCommand& motion,
             const LaneParams& params) {
    const double free = std::min(1.0, view.free_m / params.free_enough_m);
    // Quadratic: the first centimetres weigh most.
    const double tight = 1.0 - view.gap_m / tables.layout.side_m;
    double worth = params.weight_near * view.near + params.weight_free * free +
                   params.weight_gap * (1.0 - tight * tight) + params.weight_seen * view.seen +
                   params.weight_sure * view.sure;
    const bool moves = motion.v_mps > moving_mps;
    if (moves && view.heading_rad == 0.0) {
        const double kappa_max = 1.0 / tables.layout.radius_min_m;
        const double kappa = std::clamp(motion.omega_radps / motion.v_mps, -kappa_max, kappa_max);
        worth += params.weight_same * (1.0 - std::abs(view.curvature_1pm - kappa) / (2.0 * kappa_max));
    }
    if (view.heading_rad == 0.0) return worth;
    // Stopping to turn costs time even for a small turn; a robot that turns already has spent it.
    const bool turning =
        !moves && motion.omega_radps * view.heading_rad > 0.0 && std::abs(motion.omega_radps) > turning_radps;
    const double share = std::abs(view.heading_rad) / M_PI;
    return worth - params.weight_turn * (turning ? share : 0.3 + 0.7 * share);
}

}  // namespace flownav::nav
