#include "evidence.h"

#include <algorithm>

#include "contact_lines.h"

namespace flownav::mapping {
namespace {

using Eigen::Vector2d;

constexpr double seen_obstacle = 0.36;  // by a point that is surely in its cell; two cycles make it occupied
// By a contact of the scan, which two scans or many votes told: at its near end there was floor until now,
// and one sight more must outweigh it.
constexpr double seen_contact = 0.2;
constexpr double says_nothing = 0.5;
constexpr double seen_nothing = 0.55;  // by a scan that would have seen most things there, and saw none
constexpr double seen_floor = 0.57;    // weaker: a block of floor before a thin leg says little about the leg

/// A point whose range is uncertain by more than half a cell says less about that one cell.
double p_free(const ObstaclePoint& point, double cell_m) {
    const double share = std::min(1.0, cell_m / 2 / std::max(point.sigma_m, 1e-6));
    return 0.5 - (0.5 - seen_obstacle) * share * share;
}

/// Number of steps that leave out no cell.
int steps_over(double way_m, double cell_m) {
    return static_cast<int>(way_m / (cell_m / 2));
}

double share(int i, int steps) {
    return steps > 0 ? static_cast<double>(i) / steps : 0.5;
}

void add_floor(const GridFrame& frame, const Vector2d& near, const Vector2d& far, double width_m,
               std::vector<Evidence>& evidence) {
    const Vector2d along = far - near;
    const Vector2d across = Vector2d(-along.y(), along.x()).normalized() * width_m;
    const int steps = steps_over(along.norm(), frame.cell_m);
    const int side_steps = steps_over(width_m, frame.cell_m);
    for (int i = 0; i <= steps; ++i) {
        for (int k = 0; k <= side_steps; ++k) {
            const Vector2d p = near + along * share(i, steps) + across * (share(k, side_steps) - 0.5);
            const Evidence floor{frame.cell_of(p), seen_floor, false};
            if (evidence.empty() || !(evidence.back() == floor)) evidence.push_back(floor);
        }
    }
}

/// A point says that its cell is occupied, and nothing of the cells that it may be in as well: a thin leg on
/// the border of two cells is seen now in one, now in the other, and floor beside it must not outvote it.
void add_point(const GridFrame& frame, const Vector2d& p, double p_free_there,
               std::vector<Evidence>& evidence) {
    const double half_m = frame.cell_m / 2;
    for (const double dx : {-half_m, half_m})
        for (const double dy : {-half_m, half_m})
            evidence.push_back({frame.cell_of(p + Vector2d(dx, dy)), says_nothing, false});
    evidence.push_back({frame.cell_of(p), p_free_there, false});
}

/// Contacts are obstacles at the near ends of their intervals. Rims are left to RimMemory. Floor is free up
/// to the nearest obstacle of its strip and the strips beside it. Where neither floor nor a thing is seen, an
/// obstacle is doubted.
void add_contacts(const GridFrame& frame, const ContactScan& scan, const Pose2& T_frame_robot,
                  std::vector<Evidence>& evidence) {
    for_each_contact(scan, T_frame_robot, frame.cell_m / 2, [&](BeamCause cause, const Vector2d& p) {
        if (cause != BeamCause::Drop) add_point(frame, p, seen_contact, evidence);
    });
    const auto add_sight = [&](const Eigen::Vector2i& cell, FloorSight sight, double forward_m) {
        if (sight == FloorSight::Confirmed) {
            evidence.push_back({cell, seen_floor, false});
        } else if (is_looked_through(forward_m)) {
            evidence.push_back({cell, seen_nothing, true});
        }
    };
    for_each_floor_cell(scan, T_frame_robot, frame, looked_through_to_m, add_sight);
}

}  // namespace

void gather_evidence(const ObstacleSet& set, const Pose2& T_frame_robot, const GridFrame& frame,
                     std::vector<Evidence>& evidence) {
    evidence.clear();
    for (const ObstaclePoint& point : set.points) {
        if (point.moving) continue;
        const Vector2d p = transform(T_frame_robot, point.position_m.head<2>());
        add_point(frame, p, p_free(point, frame.cell_m), evidence);
    }
    for (const GroundPatch& patch : set.ground) {
        add_floor(frame, transform(T_frame_robot, patch.near_m), transform(T_frame_robot, patch.far_m),
                  patch.width_m, evidence);
    }
    add_contacts(frame, set.contacts, T_frame_robot, evidence);
    std::sort(evidence.begin(), evidence.end());
    evidence.erase(std::unique(evidence.begin(), evidence.end()), evidence.end());
    const auto is_silent = [](const Evidence& e) { return e.p_free == says_nothing; };
    evidence.erase(std::remove_if(evidence.begin(), evidence.end(), is_silent), evidence.end());
}

}  // namespace flownav::mapping
