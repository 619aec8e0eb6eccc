#include "flownav/nav/ground_memory.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "flownav/core/contact_floor.h"
#include "flownav/mapping/grid_area.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

constexpr double deep_inside_m = 0.05;    // an obstacle this far inside the footprint is none
constexpr double floor_share_max = 0.97;  // no scan is sure to see the floor
constexpr double sure_within_m = 0.8;     // ahead of the camera a scan misses floor less often
constexpr int scans_through_min = 3;      // that saw nothing where an obstacle is remembered
constexpr int confirmations_max = 2;      // of one cell that count
constexpr int scans_min = 2;              // that looked at ground without texture

/// -log of the chance that a scan misses floor in a strip: large where most strips show floor, 0 where the
/// floor has no texture.
double doubt_of(const ContactScan& scan) {
    return -std::log(1.0 - std::min(floor_share(scan), floor_share_max));
}

}  // namespace

GroundMemory::GroundMemory(const GroundMemoryParams& params)
    : params_(params),
      cells_({Vector2d::Zero(), params.cell_m},
             2 * static_cast<int>(std::ceil(params.reach_m / params.cell_m)) + 2) {}

Ground GroundMemory::at(const Vector2i& cell, double time_s) const {
    const Known* const known = cells_.find(cell);
    return known && time_s <= known->until_s ? known->ground : Ground::Unknown;
}

int GroundMemory::note(const mrpt::maps::COccupancyGridMap2D& local_map, double time_s,
                       const Pose2& T_map_robot) {
    map_s_ = time_s;
    const Vector2i middle = cells_.frame().cell_of({T_map_robot.x_m, T_map_robot.y_m});
    const Pose2 T_robot_map = inverse(T_map_robot);
    const Vector2d origin = transform(T_robot_map, {0.0, 0.0});
    const Vector2d along_x = transform(T_robot_map, {params_.cell_m, 0.0}) - origin;
    const Vector2d along_y = transform(T_robot_map, {0.0, params_.cell_m}) - origin;
    const GridArea area = mapping::area_of(local_map);
    const int half = cells_.side() / 2;
    int fresh = 0;
    for (int y = middle.y() - half + 1; y < middle.y() + half; ++y) {
        for (int x = middle.x() - half + 1; x < middle.x() + half; ++x) {
            const Vector2d p = origin + (x + 0.5) * along_x + (y + 0.5) * along_y;
            const double p_free = mapping::p_free_at(local_map, area, p);
            const bool is_free = p_free > params_.limits.guard_free_above;
            if (is_free || p_free < params_.limits.guard_obstacle_below) {
                fresh += note_cell({x, y}, is_free, time_s);
            } else {
                note_unknown({x, y}, p, time_s);
            }
        }
    }
    return fresh;
}

void GroundMemory::note(const ContactScan& scan, double time_s, const Pose2& T_map_robot) {
    view_begin_m_ = scan.camera_m.x() + scan.view_near_m;
    const double doubt = doubt_of(scan);
    const Vector2i middle = cells_.frame().cell_of({T_map_robot.x_m, T_map_robot.y_m});
    const auto note_sight = [&](const Vector2i& cell, FloorSight sight, double forward_m) {
        if ((cell - middle).cwiseAbs().maxCoeff() >= cells_.side() / 2) return;
        if (sight == FloorSight::Confirmed) {
            note_confirmed(cell, time_s);
            look_through(cell, time_s);
            return;
        }
        doubt_confirmed(cell);
        if (forward_m < params_.unconfirmed_within_m)
            note_unconfirmed(cell, forward_m < sure_within_m ? 2.0 * doubt : doubt, time_s);
        if (is_looked_through(forward_m)) look_through(cell, time_s);
    };
    const double to_m = std::max(params_.unconfirmed_within_m, looked_through_to_m);
    for_each_floor_cell(scan, T_map_robot, cells_.frame(), to_m, note_sight);
}

void GroundMemory::note_confirmed(const Vector2i& cell, double time_s) {
    Known& known = cells_.claim(cell);
    known.confirmed_until_s = time_s + params_.free_s;
    known.confirmations = std::min(known.confirmations + 1, confirmations_max);
    if (known.ground == Ground::Unconfirmed) known.ground = Ground::Unknown;
    known.doubt = 0.0;
}

/// A scan that saw the floor end before this cell takes back one that confirmed it.
void GroundMemory::doubt_confirmed(const Vector2i& cell) {
    Known* const known = cells_.find(cell);
    if (!known || known->confirmations == 0 || --known->confirmations > 0) return;
    known->confirmed_until_s = -std::numeric_limits<double>::infinity();
}

/// Forgets an obstacle that the map no longer shows after some scans in a row saw nothing there.
void GroundMemory::look_through(const Vector2i& cell, double time_s) {
    if (at(cell, time_s) != Ground::Occupied) return;
    Known& known = cells_.claim(cell);
    if (++known.scans >= scans_through_min) known = {};
}

void GroundMemory::note_unconfirmed(const Vector2i& cell, double doubt, double time_s) {
    const Ground before = at(cell, time_s);
    if (before == Ground::Driven || before == Ground::Occupied) return;
    Known& known = cells_.claim(cell);
    if (time_s <= known.confirmed_until_s) return;
    if (before == Ground::Free && known.until_s >= map_s_ + params_.free_s) return;  // the map shows it free
    known.doubt = time_s <= known.until_s ? known.doubt + doubt : doubt;
    known.scans = time_s <= known.until_s ? known.scans + 1 : 1;
    const bool is_doubted = known.doubt > -std::log(params_.unconfirmed_chance);
    if (before == Ground::Free && !is_doubted) return;
    known.ground = is_doubted ? Ground::Unconfirmed : Ground::Unknown;
    known.until_s = time_s + params_.unconfirmed_s;
}

/// True: free, and it was unknown.
bool GroundMemory::note_cell(const Vector2i& cell, bool is_free, double time_s) {
    const Ground before = at(cell, time_s);
    Known& known = cells_.claim(cell);
    if (!is_free) {
        known = {Ground::Occupied, time_s + params_.obstacle_s};
    } else if (before != Ground::Driven || known.until_s < time_s + params_.free_s) {
        known.ground = Ground::Free;
        known.until_s = time_s + params_.free_s;
        known.doubt = 0.0;
    }
    return is_free && (before == Ground::Unknown || before == Ground::Unconfirmed);
}

/// Shortens the memory of an obstacle in view of the camera that the map no longer shows; obstacles beside,
/// behind and right before the robot keep theirs.
void GroundMemory::note_unknown(const Vector2i& cell, const Vector2d& at_robot_m, double time_s) {
    Known* const known = cells_.find(cell);
    if (!known || known->ground != Ground::Occupied) return;
    const bool in_view = at_robot_m.x() > view_begin_m_ &&
                         std::abs(std::atan2(at_robot_m.y(), at_robot_m.x())) < params_.view_half_rad;
    if (in_view) known->until_s = std::min(known->until_s, time_s + params_.in_view_s);
}

void GroundMemory::mark_traversed(const Polygon& footprint_m, double time_s, const Pose2& T_map_robot) {
    const Vector2d centre(T_map_robot.x_m, T_map_robot.y_m);
    const Vector2d reach = Vector2d::Constant(circumscribed_radius_m(footprint_m));
    const GridFrame& frame = cells_.frame();
    const Vector2i low = frame.cell_of(centre - reach);
    const Vector2i high = frame.cell_of(centre + reach);
    const Pose2 T_robot_map = inverse(T_map_robot);
    for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
            const Vector2i cell(x, y);
            const double outside_m =
                signed_distance_m(footprint_m, transform(T_robot_map, frame.middle_of(cell)));
            const bool is_obstacle = at(cell, time_s) == Ground::Occupied;
            if (outside_m > (is_obstacle ? -deep_inside_m : 0.0)) continue;
            cells_.claim(cell) = {Ground::Driven, time_s + params_.driven_s};
        }
    }
}

Ground GroundMemory::at(const Vector2d& at_m, double time_s) const {
    return at(cells_.frame().cell_of(at_m), time_s);
}

bool GroundMemory::is_seen(const Vector2d& at_m, double time_s) const {
    const Ground here = at(at_m, time_s);
    if (here == Ground::Driven || here == Ground::Free) return true;
    if (here == Ground::Occupied) return false;
    const double d = params_.seen_near_m;
    const double e = d * std::sqrt(0.5);
    const std::array<Vector2d, 8> around = {Vector2d(d, 0), {e, e},   {0, d},  {-e, e},
                                            {-d, 0},        {-e, -e}, {0, -d}, {e, -e}};
    return std::any_of(around.begin(), around.end(), [&](const Vector2d& offset) {
        return at(Vector2d(at_m + offset), time_s) == Ground::Free;
    });
}

bool GroundMemory::is_unconfirmed(const Vector2d& at_m, double time_s) const {
    const Vector2i cell = cells_.frame().cell_of(at_m);
    if (at(cell, time_s) != Ground::Unconfirmed) return false;
    const std::array<Vector2i, 4> sides = {Vector2i(1, 0), {1, 1}, {0, 1}, {-1, 1}};
    return std::none_of(sides.begin(), sides.end(), [&](const Vector2i& side) {
        return at(Vector2i(cell + side), time_s) == Ground::Free &&
               at(Vector2i(cell - side), time_s) == Ground::Free;
    });
}

bool GroundMemory::is_scanned(const Vector2d& at_m, double time_s) const {
    const Vector2i cell = cells_.frame().cell_of(at_m);
    const Known* const known = cells_.find(cell);
    return known && known->scans >= scans_min && at(cell, time_s) == Ground::Unknown &&
           time_s <= known->until_s;
}

bool GroundMemory::is_confirmed(const Vector2d& at_m, double time_s) const {
    const Vector2i cell = cells_.frame().cell_of(at_m);
    const Known* const known = cells_.find(cell);
    return known && (time_s <= known->confirmed_until_s || at(cell, time_s) == Ground::Driven);
}

std::vector<Vector2d> GroundMemory::obstacles(const Vector2d& around_m, double radius_m,
                                              double time_s) const {
    const double reach_m = std::min(radius_m, params_.reach_m);
    const GridFrame& frame = cells_.frame();
    const Vector2i low = frame.cell_of(around_m - Vector2d::Constant(reach_m));
    const Vector2i high = frame.cell_of(around_m + Vector2d::Constant(reach_m));
    std::vector<Vector2d> found;
    for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
            if (at(Vector2i(x, y), time_s) != Ground::Occupied) continue;
            const Vector2d middle = frame.middle_of({x, y});
            if ((middle - around_m).norm() <= reach_m) found.push_back(middle);
        }
    }
    return found;
}

}  // namespace flownav::nav
