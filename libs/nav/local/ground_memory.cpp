#include "flownav/nav/ground_memory.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "flownav/mapping/grid_area.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

constexpr double deep_inside_m = 0.05;  // an obstacle this far inside the footprint is none

int wrapped(int i, int side) {
    const int rest = i % side;
    return rest < 0 ? rest + side : rest;
}

}  // namespace

GroundMemory::GroundMemory(const GroundMemoryParams& params)
    : params_(params),
      frame_{Vector2d::Zero(), params.cell_m},
      side_(2 * static_cast<int>(std::ceil(params.reach_m / params.cell_m)) + 2),
      cells_(static_cast<std::size_t>(side_) * side_) {}

GroundMemory::Cell& GroundMemory::place(const Vector2i& index) {
    return cells_[static_cast<std::size_t>(wrapped(index.y(), side_)) * side_ + wrapped(index.x(), side_)];
}

const GroundMemory::Cell& GroundMemory::place(const Vector2i& index) const {
    return cells_[static_cast<std::size_t>(wrapped(index.y(), side_)) * side_ + wrapped(index.x(), side_)];
}

Ground GroundMemory::at(const Vector2i& index, double time_s) const {
    const Cell& cell = place(index);
    return cell.index == index && time_s <= cell.until_s ? cell.ground : Ground::Unknown;
}

int GroundMemory::note(const mrpt::maps::COccupancyGridMap2D& local_map, double time_s,
                       const Pose2& T_map_robot) {
    const Vector2i middle = frame_.cell_of({T_map_robot.x_m, T_map_robot.y_m});
    const Pose2 T_robot_map = inverse(T_map_robot);
    const Vector2d origin = transform(T_robot_map, {0.0, 0.0});
    const Vector2d along_x = transform(T_robot_map, {params_.cell_m, 0.0}) - origin;
    const Vector2d along_y = transform(T_robot_map, {0.0, params_.cell_m}) - origin;
    const GridArea area = mapping::area_of(local_map);
    int fresh = 0;
    for (int y = middle.y() - side_ / 2 + 1; y < middle.y() + side_ / 2; ++y) {
        for (int x = middle.x() - side_ / 2 + 1; x < middle.x() + side_ / 2; ++x) {
            const Vector2d p = origin + (x + 0.5) * along_x + (y + 0.5) * along_y;
            const double p_free = mapping::p_free_at(local_map, area, p);
            if (p_free < params_.p_occupied || p_free > params_.p_free) {
                fresh += note_cell({x, y}, p_free > params_.p_free, time_s);
            } else {
                note_silence({x, y}, p, time_s);
            }
        }
    }
    return fresh;
}

/// True: free, and it was unknown.
bool GroundMemory::note_cell(const Vector2i& index, bool is_free, double time_s) {
    const Ground before = at(index, time_s);
    Cell& cell = place(index);
    if (!is_free) {
        cell = {index, Ground::Occupied, time_s + params_.obstacle_s};
    } else if (before != Ground::Driven || cell.until_s < time_s + params_.free_s) {
        cell = {index, Ground::Free, time_s + params_.free_s};
    }
    return is_free && before == Ground::Unknown;
}

/// The map says nothing: a mover that went away in front of the robot is soon forgotten, what stands beside
/// or behind it is not.
void GroundMemory::note_silence(const Vector2i& index, const Vector2d& at_robot_m, double time_s) {
    Cell& cell = place(index);
    if (cell.index != index || cell.ground != Ground::Occupied) return;
    const bool in_view = std::abs(std::atan2(at_robot_m.y(), at_robot_m.x())) < params_.view_half_rad;
    if (in_view) cell.until_s = std::min(cell.until_s, time_s + params_.in_view_s);
}

void GroundMemory::mark_traversed(const Polygon& footprint_m, double time_s, const Pose2& T_map_robot) {
    const Vector2d centre(T_map_robot.x_m, T_map_robot.y_m);
    const Vector2d reach = Vector2d::Constant(circumscribed_radius_m(footprint_m));
    const Vector2i low = frame_.cell_of(centre - reach);
    const Vector2i high = frame_.cell_of(centre + reach);
    const Pose2 T_robot_map = inverse(T_map_robot);
    for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
            const Vector2i index(x, y);
            const double outside_m =
                signed_distance_m(footprint_m, transform(T_robot_map, frame_.middle_of(index)));
            const bool is_obstacle = at(index, time_s) == Ground::Occupied;
            if (outside_m > (is_obstacle ? -deep_inside_m : 0.0)) continue;
            place(index) = {index, Ground::Driven, time_s + params_.driven_s};
        }
    }
}

Ground GroundMemory::at(const Vector2d& at_m, double time_s) const {
    return at(frame_.cell_of(at_m), time_s);
}

bool GroundMemory::is_seen(const Vector2d& at_m, double time_s) const {
    const Ground here = at(at_m, time_s);
    if (here != Ground::Unknown) return here != Ground::Occupied;
    const double d = params_.seen_near_m;
    const double e = d * std::sqrt(0.5);
    const std::array<Vector2d, 8> around = {Vector2d(d, 0), {e, e},   {0, d},  {-e, e},
                                            {-d, 0},        {-e, -e}, {0, -d}, {e, -e}};
    return std::any_of(around.begin(), around.end(), [&](const Vector2d& offset) {
        return at(Vector2d(at_m + offset), time_s) == Ground::Free;
    });
}

std::vector<Vector2d> GroundMemory::obstacles(const Vector2d& around_m, double radius_m,
                                              double time_s) const {
    const double reach_m = std::min(radius_m, params_.reach_m);
    const Vector2i low = frame_.cell_of(around_m - Vector2d::Constant(reach_m));
    const Vector2i high = frame_.cell_of(around_m + Vector2d::Constant(reach_m));
    std::vector<Vector2d> found;
    for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
            const Vector2i index(x, y);
            if (at(index, time_s) != Ground::Occupied) continue;
            if ((frame_.middle_of(index) - around_m).norm() <= reach_m)
                found.push_back(frame_.middle_of(index));
        }
    }
    return found;
}

}  // namespace flownav::nav
