#include "evidence.h"

#include <algorithm>

#include "contact_lines.h"

namespace flownav::mapping {
namespace {

using Eigen::Vector2d;

constexpr double seen_obstacle = 0.36;  // by a point that is surely in its cell; two cycles make it occupied
// By a contact of the scan, which two scans or many votes told: where it stands there may have been floor
// until now, and one sight more must outweigh it.
constexpr double seen_contact = 0.2;
constexpr double depth_m = 0.1;  // least depth of things, whose backs nobody sees
constexpr double behind_contact = 0.4;
constexpr double says_nothing = 0.5;
constexpr double seen_nothing = 0.55;    // by a scan that would have seen most things there, and saw none
constexpr double seen_no_floor = 0.43;   // by a scan that sees floor elsewhere
constexpr double floor_sure_to_m = 1.2;  // ahead of the camera
constexpr double floor_share_min = 0.5;  // of the strips: the floor has texture
constexpr double seen_farther = 0.6;     // by a scan that saw the contact farther away
constexpr double contact_error = 0.03;
constexpr double seen_floor = 0.57;  // weaker: a block of floor before a thin leg says little about the leg

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

/// Forward distance from the camera up to which a contact is surely not: the best estimates of the strip and
/// its neighbours, less their usual errors.
double before_m(const ContactScan& scan, int strip) {
    double to_m = scan.strips[static_cast<std::size_t>(strip)].contact_m;
    for (int i = std::max(0, strip - 1); i <= std::min(static_cast<int>(scan.strips.size()) - 1, strip + 1);
         ++i) {
        const ContactStrip& beside = scan.strips[static_cast<std::size_t>(i)];
        if (beside.kind == BeamKind::Obstacle) to_m = std::min(to_m, beside.contact_m);
    }
    return (1.0 - contact_error) * to_m;
}

/// The scan sees every contact a little nearer or farther away. An obstacle before it, which only one of many
/// scans saw there, is doubted.
void doubt_before_contacts(const GridFrame& frame, const ContactScan& scan, const Pose2& T_frame_robot,
                           std::vector<Evidence>& evidence) {
    const double step_m = frame.cell_m / 2;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        const ContactStrip& strip = scan.strips[static_cast<std::size_t>(i)];
        if (strip.kind != BeamKind::Obstacle || strip.cause == BeamCause::Drop) continue;
        const double to_m = before_m(scan, i) - frame.cell_m;
        for (double forward_m = strip.near_m; forward_m < to_m; forward_m += step_m) {
            const auto at = [&](double tangent) {
                return transform(T_frame_robot, point_of(scan, tangent, forward_m));
            };
            const double half = scan.step / 2;
            for_each_point(at(middle_tangent(scan, i) - half), at(middle_tangent(scan, i) + half), step_m,
                           [&](const Vector2d& p) {
                               evidence.push_back({frame.cell_of(p), seen_farther, true});
                           });
        }
    }
}

/// Contacts are obstacles at their best estimates. Rims are left to RimMemory. Floor is free up
/// to the nearest obstacle of its strip and the strips beside it. Where neither floor nor a thing is seen, an
/// obstacle is doubted.
void add_contacts(const GridFrame& frame, const ContactScan& scan, const Pose2& T_frame_robot,
                  std::vector<Evidence>& evidence) {
    const Vector2d camera_m = transform(T_frame_robot, point_of(scan, 0.0, 0.0));
    for_each_contact(scan, T_frame_robot, frame.cell_m / 2, [&](BeamCause cause, const Vector2d& p) {
        if (cause == BeamCause::Drop) return;
        add_point(frame, p, seen_contact, evidence);
        const Vector2d behind = (p - camera_m).normalized() * depth_m;
        for_each_point(p, p + behind, frame.cell_m / 2, [&](const Vector2d& inside) {
            evidence.push_back({frame.cell_of(inside), behind_contact, false});
        });
    });
    doubt_before_contacts(frame, scan, T_frame_robot, evidence);
    const bool sees_floor = floor_share(scan) > floor_share_min;
    const auto add_sight = [&](const Eigen::Vector2i& cell, FloorSight sight, double forward_m) {
        if (sight == FloorSight::Confirmed) {
            evidence.push_back({cell, seen_floor, false});
            return;
        }
        if (forward_m < floor_sure_to_m && sees_floor) evidence.push_back({cell, seen_no_floor, true});
        if (is_looked_through(forward_m)) evidence.push_back({cell, seen_nothing, true});
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
