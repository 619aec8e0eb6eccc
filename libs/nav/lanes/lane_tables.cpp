#include "flownav/nav/lane_tables.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "flownav/mapping/grid_area.h"
#include "flownav/nav/motion_model.h"
#include "local/sweep.h"

namespace flownav::nav {
namespace {

constexpr double turn_max_rad = 2.6;  // limit of an arc's turn; larger turns are made on the spot
constexpr double unit_m = 0.001;
constexpr double unit_rad = 0.001;

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("lane layout: " + what);
}

void check(const LaneLayout& layout, const RobotModel& robot) {
    require(robot.footprint_m.size() >= 3, "the footprint needs at least three corners");
    require(layout.resolution_m > 0.0, "resolution_m must be > 0");
    require(layout.lanes >= 3 && layout.lanes % 2 == 1, "lanes must be odd, 3 or more");
    require(layout.headings >= 4, "headings must be 4 or more");
    require(layout.radius_min_m > 0.0, "radius_min_m must be > 0");
    require(layout.margin_m >= 0.0 && layout.side_m > layout.margin_m, "side_m must be > margin_m >= 0");
    require(layout.tight_margin_m >= 0.0 && layout.tight_margin_m <= layout.margin_m,
            "tight_margin_m must be in 0..margin_m");
    require(layout.side_m <= 255 * gap_unit_m, "side_m must be <= 1.275");
    require(layout.length_m > 0.0 && layout.length_m < 60.0, "length_m must be in 0..60");
    require(layout.map_size_m / 2 > circumscribed_radius_m(robot.footprint_m) + layout.side_m,
            "map_size_m is too small for the robot");
}

GridArea cells_of(const LaneLayout& layout) {
    const auto half = static_cast<float>(layout.map_size_m / 2);
    return mapping::area_of({-half, half, -half, half, static_cast<float>(layout.resolution_m)});
}

/// Spaces lanes more densely near straight ahead, where small differences matter most.
double curvature_1pm(const LaneLayout& layout, int lane) {
    const int half = layout.lanes / 2;
    const double share = static_cast<double>(lane - half) / half;
    return share * std::pow(std::abs(share), 0.7) / layout.radius_min_m;
}

/// Limits a lane to poses whose centre stays in the map.
double length_m(const LaneLayout& layout, double curvature, double reach_m) {
    const double in_map_m = layout.map_size_m / 2 - reach_m;
    const double turn_m = curvature == 0.0 ? layout.length_m : turn_max_rad / std::abs(curvature);
    return std::min({layout.length_m, turn_m, in_map_m});
}

Lane swept(const FootprintField& field, const GridArea& grid, Lane lane, double margin_m) {
    const Pose2 turned{0.0, 0.0, lane.heading_rad};
    const auto pose_of = [&lane, &turned](double way_m) {
        return compose(turned, pose_after({1.0, lane.curvature_1pm}, way_m));
    };
    const double step_m = std::min(0.025, grid.cell_m / 2);
    lane.cells = sweep(field, grid, pose_of, {lane.length_m, step_m, margin_m, unit_m});
    return lane;
}

}  // namespace

LaneTables make_lane_tables(const RobotModel& robot, const LaneLayout& layout) {
    check(layout, robot);
    LaneTables tables{
        layout, robot, FootprintField(robot.footprint_m, layout.side_m), cells_of(layout), {}, {}, {},
        {},     {}};
    const FootprintField& field = tables.field;
    for (int i = 0; i < layout.lanes; ++i) {
        Lane lane{curvature_1pm(layout, i), 0.0, 0.0, {}};
        lane.length_m = length_m(layout, lane.curvature_1pm, circumscribed_radius_m(robot.footprint_m));
        tables.lanes.push_back(swept(field, tables.grid, lane, layout.margin_m));
        tables.tight_lanes.push_back(swept(field, tables.grid, lane, layout.tight_margin_m));
    }
    for (int i = 0; i < layout.headings; ++i) {
        Lane lane{0.0, -M_PI + 2.0 * M_PI * i / layout.headings, 0.0, {}};
        lane.length_m = length_m(layout, 0.0, circumscribed_radius_m(robot.footprint_m));
        tables.headings.push_back(swept(field, tables.grid, lane, layout.margin_m));
    }
    const SweepParams turn{M_PI, 0.04, layout.tight_margin_m, unit_rad};
    tables.turn_left = sweep(
        field, tables.grid,
        [](double way) {
            return Pose2{0.0, 0.0, way};
        },
        turn);
    tables.turn_right = sweep(
        field, tables.grid,
        [](double way) {
            return Pose2{0.0, 0.0, -way};
        },
        turn);
    return tables;
}

}  // namespace flownav::nav
