#include "flownav/nav/lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "flownav/mapping/grid_area.h"
#include "flownav/nav/motion_model.h"
#include "lane_view.h"
#include "local/can_still_stop.h"
#include "turning.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::maps::COccupancyGridMap2D;

constexpr double least_turn_rad = 0.25;         // smaller turns are made while driving
constexpr double least_near_after_turn = -0.3;  // after a turn, a detour may lead away at first
constexpr double stands_mps = 0.1;              // slow enough to turn on the spot
constexpr double squeeze_mps = 0.15;
constexpr double unseen_depth_m = 0.05;  // of the smallest patch of unseen ground that counts
constexpr double least_way_m = 0.05;     // shorter lanes are not open

/// Distance to an obstacle ahead that leaves room to turn away from it on the spot.
double room_to_turn_m(const Polygon& footprint_m) {
    double front_m = 0.0;
    for (const Vector2d& corner : footprint_m) front_m = std::max(front_m, corner.x());
    return circumscribed_radius_m(footprint_m) - front_m;
}

bool same_cells(const GridArea& a, const GridArea& b) {
    const double tolerance_m = 0.01 * a.cell_m;
    return a.columns == b.columns && a.rows == b.rows && std::abs(a.cell_m - b.cell_m) < tolerance_m &&
           (a.origin_m - b.origin_m).cwiseAbs().maxCoeff() < tolerance_m;
}

class Choice {
  public:
    Choice(const LaneTables& tables, const COccupancyGridMap2D& map, Vector2d waypoint_m,
           const MotionCommand& motion, const LaneParams& params)
        : tables_(tables),
          waypoint_m_(std::move(waypoint_m)),
          motion_(motion),
          params_(params),
          kinds_(kinds_of(map, params.limits)) {
        obstacles_m_ = obstacles_near(map, kinds_, reach_m(tables.robot, tables.field, params));
        params_.standoff_m = std::max(params.standoff_m, room_to_turn_m(tables.robot.footprint_m));
        free_left_rad_ = free_turn_rad(tables.turn_left, kinds_);
        free_right_rad_ = free_turn_rad(tables.turn_right, kinds_);
    }

    LaneDecision run() {
        for (const Lane& lane : tables_.lanes) decision_.lanes.push_back(view_of(lane));
        if (wants_to_turn(waypoint_m_, motion_, params_)) {
            const double bearing = bearing_rad(waypoint_m_);
            if (turn_to(bearing, "turns to the way point")) return decision_;
            if (turn_to(bearing - std::copysign(2.0 * M_PI, bearing), "turns the other way"))
                return decision_;
        }
        for (const Lane& lane : tables_.headings) decision_.headings.push_back(view_of(lane));
        if (take_the_best() || squeeze()) return decision_;
        decision_.stuck = true;
        decision_.why = "no lane is open";
        return decision_;
    }

  private:
    LaneView view_of(const Lane& lane) const {
        LaneView view = look_along(tables_, lane, kinds_, params_);
        view.near = nearness(view, waypoint_m_, params_);
        view.open = view.free_m - params_.standoff_m > least_way_m;
        view.score = score(tables_, view, motion_, params_);
        return view;
    }

    bool may_turn(double angle_rad) const {
        return std::abs(angle_rad) < (angle_rad > 0.0 ? free_left_rad_ : free_right_rad_);
    }

    bool turn_to(double angle_rad, const char* why) {
        // The tables cover half a turn; the rest is checked after it.
        const double first_rad = std::clamp(angle_rad, -M_PI + 1e-6, M_PI - 1e-6);
        if (!may_turn(first_rad)) return false;
        const bool stands = std::abs(motion_.v_mps) < stands_mps;
        decision_.command = stands ? turn_by(tables_.robot, angle_rad) : MotionCommand{};
        decision_.why = stands ? why : "stops to turn";
        return true;
    }

    /// Takes the best open lane, or heading to turn to, from which the robot could still stop.
    bool take_the_best() {
        const auto arcs = static_cast<int>(decision_.lanes.size());
        const auto view = [this, arcs](int i) -> const LaneView& {
            return i < arcs ? decision_.lanes[i] : decision_.headings[i - arcs];
        };
        std::vector<int> order(arcs + decision_.headings.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&view](int a, int b) { return view(a).score > view(b).score; });
        for (const double share : {1.0, 0.5, 0.2}) {
            for (const int i : order)
                if (i < arcs ? take_lane(i, share) : take_heading(i - arcs)) return true;
        }
        return false;
    }

    bool take_lane(int i, double speed_share) {
        const LaneView& view = decision_.lanes[i];
        if (!view.open || view.near <= 0.0 || !drive(view, speed_share * speed_mps(view))) return false;
        decision_.lane = i;
        if (speed_share < 1.0) decision_.why += ", slow enough to stop";
        return true;
    }

    bool drive(const LaneView& view, double v_mps) {
        const MotionCommand command{v_mps, v_mps * view.curvature_1pm};
        if (!can_still_stop(tables_.robot, tables_.field, obstacles_m_, motion_, command, params_))
            return false;
        decision_.command = command;
        decision_.way = {view.free_m, view.unseen_m};
        return true;
    }

    bool take_heading(int i) {
        const LaneView& view = decision_.headings[i];
        if (!view.open || view.near < least_near_after_turn || std::abs(view.heading_rad) < least_turn_rad ||
            !turn_to(view.heading_rad, "turns to an open lane"))
            return false;
        decision_.heading = i;
        decision_.way = {view.free_m, view.unseen_m};
        return true;
    }

    /// Last resort: drives slowly along the best lane with the tight margin.
    bool squeeze() {
        const double slow_mps = std::min(squeeze_mps, tables_.robot.v_max_mps);
        const Lane* best = nullptr;
        LaneView best_view;
        for (const Lane& lane : tables_.tight_lanes) {
            const LaneView view = view_of(lane);
            if (!view.open || view.near <= 0.0 || (best && view.score <= best_view.score)) continue;
            best = &lane;
            best_view = view;
        }
        if (!best || !drive(best_view, std::min(slow_mps, speed_mps(best_view)))) return false;
        decision_.lane = static_cast<int>(best - tables_.tight_lanes.data());
        decision_.why = "squeezes through";
        return true;
    }

    double speed_mps(const LaneView& view) {
        const RobotModel& robot = tables_.robot;
        struct Limit {
            double v_mps;
            const char* why;
        };
        const double gap = std::clamp(view.gap_m / tables_.layout.side_m, 0.0, 1.0);
        const double unseen_m = view.unseen_m - params_.bumper_m - unseen_depth_m;
        const std::array<Limit, 6> limits = {{
            {robot.v_max_mps, "drives"},
            {robot.omega_max_radps / std::max(1e-6, std::abs(view.curvature_1pm)), "turns hard"},
            {stoppable_speed_mps(robot, view.free_m - params_.standoff_m), "slows for an obstacle"},
            {view.unseen_m < view.free_m ? std::max(params_.unseen_mps, stoppable_speed_mps(robot, unseen_m))
                                         : robot.v_max_mps,
             "slows for unseen ground"},
            {robot.v_max_mps * (params_.narrow_share + (1.0 - params_.narrow_share) * gap),
             "slow in a narrow place"},
            {std::max(params_.arrival_mps, stoppable_speed_mps(robot, waypoint_m_.norm())), "arrives"},
        }};
        const Limit least = *std::min_element(
            limits.begin(), limits.end(), [](const Limit& a, const Limit& b) { return a.v_mps < b.v_mps; });
        decision_.why = least.why;
        return least.v_mps;
    }

    const LaneTables& tables_;
    const Vector2d waypoint_m_;
    const MotionCommand motion_;
    LaneParams params_;
    std::vector<CellKind> kinds_;
    std::vector<Vector2d> obstacles_m_;
    double free_left_rad_ = 0.0;
    double free_right_rad_ = 0.0;
    LaneDecision decision_;
};

}  // namespace

LaneDecision choose_lane(const LaneTables& tables, const COccupancyGridMap2D& local_map,
                         const Vector2d& waypoint_robot_m, const MotionCommand& motion,
                         const LaneParams& params) {
    if (!same_cells(tables.grid, mapping::area_of(local_map))) {
        throw std::invalid_argument(
            "the local map does not fit the lane tables: make them for its size and "
            "resolution");
    }
    return Choice(tables, local_map, waypoint_robot_m, motion, params).run();
}

}  // namespace flownav::nav
