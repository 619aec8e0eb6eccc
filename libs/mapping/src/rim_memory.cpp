#include "flownav/mapping/rim_memory.h"

#include <algorithm>

#include "contact_lines.h"

namespace flownav::mapping {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;

// A cycle gives up to two sets, one of its blocks and one of its contact scan: three cycles.
constexpr int sights_that_refute = 6;

bool is_before(const Vector2i& a, const Vector2i& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

/// The rim in a cell, or where it belongs.
template <class Rims>
auto place_of(Rims& rims, const Vector2i& cell) {
    return std::lower_bound(rims.begin(), rims.end(), cell, [](const Rim& rim, const Vector2i& wanted) {
        return is_before(rim.cell, wanted);
    });
}

}  // namespace

RimMemory::RimMemory(double cell_m) : frame_{Vector2d::Zero(), cell_m} {}

void RimMemory::note(const ObstacleSet& set, const GridFrame& frame, const std::vector<Evidence>& evidence) {
    const Vector2d robot_m(set.T_map_robot.x_m, set.T_map_robot.y_m);
    removed_m_.clear();
    if (!rims_.empty()) {
        for (const Evidence& e : evidence)
            if (e.p_free > 0.5) note_floor(robot_m, frame.middle_of(e.cell));
        remove_refuted();
    }
    for_each_contact(set.contacts, set.T_map_robot, frame_.cell_m / 2,
                     [&](BeamCause cause, const Vector2d& p) {
                         if (cause == BeamCause::Drop) add(robot_m, p);
                     });
}

void RimMemory::note_floor(const Vector2d& robot_m, const Vector2d& floor_m) {
    const Vector2i cell = frame_.cell_of(floor_m);
    const auto rim = place_of(rims_, cell);
    if (rim == rims_.end() || rim->cell != cell) return;
    if ((floor_m - robot_m).norm() <= rim->seen_from_m + frame_.cell_m) ++rim->floor_sights;
}

void RimMemory::remove_refuted() {
    const auto is_refuted = [](const Rim& rim) { return rim.floor_sights >= sights_that_refute; };
    for (const Rim& rim : rims_)
        if (is_refuted(rim)) removed_m_.push_back(frame_.middle_of(rim.cell));
    rims_.erase(std::remove_if(rims_.begin(), rims_.end(), is_refuted), rims_.end());
}

void RimMemory::add(const Vector2d& robot_m, const Vector2d& rim_m) {
    const Vector2i cell = frame_.cell_of(rim_m);
    const double from_m = (rim_m - robot_m).norm();
    const auto rim = place_of(rims_, cell);
    if (rim != rims_.end() && rim->cell == cell) {
        rim->seen_from_m = std::min(rim->seen_from_m, from_m);
        rim->floor_sights = 0;
    } else {
        rims_.insert(rim, {cell, from_m, 0});
    }
}

}  // namespace flownav::mapping
