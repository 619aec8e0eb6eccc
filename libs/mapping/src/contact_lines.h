#pragma once

#include "flownav/core/contact_floor.h"

namespace flownav::mapping {

/// Calls visit(p_m) for points of a line from `from_m` to `to_m`, at most `step_m` apart, with both ends.
template <class Visit>
void for_each_point(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, double step_m,
                    const Visit& visit) {
    const int steps = static_cast<int>((to_m - from_m).norm() / step_m) + 1;
    for (int i = 0; i <= steps; ++i) visit(Eigen::Vector2d(from_m + (to_m - from_m) * i / steps));
}

/// Calls visit(cause, p_m) for points of a frame at most `step_m` apart, along the lines of all obstacles of
/// a scan. T_frame_robot: robot frame of the scan's record.
template <class Visit>
void for_each_contact(const ContactScan& scan, const Pose2& T_frame_robot, double step_m,
                      const Visit& visit) {
    for (std::size_t i = 0; i < scan.strips.size(); ++i) {
        if (scan.strips[i].kind != BeamKind::Obstacle) continue;
        const ContactLine line = line_of(scan, static_cast<int>(i));
        const Eigen::Vector2d middle_m = transform(T_frame_robot, line.middle_m);
        const auto point = [&](const Eigen::Vector2d& p_m) { visit(scan.strips[i].cause, p_m); };
        for_each_point(transform(T_frame_robot, line.left_m), middle_m, step_m, point);
        for_each_point(middle_m, transform(T_frame_robot, line.right_m), step_m, point);
    }
}

}  // namespace flownav::mapping
