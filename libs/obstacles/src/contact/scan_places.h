#pragma once
#include <cmath>

#include "flownav/core/contact_scan.h"

namespace flownav::obstacles {

/// Distance between two poses.
inline double way_m(const Pose2& a, const Pose2& b) {
    return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m);
}

/// Place of a contact of the scan that was made at T_start_robot, in the frame of T_start_robot. `right`:
/// tangent of the angle to the right of the heading.
inline Eigen::Vector2d place_of(const ContactScan& scan, const Pose2& T_start_robot, double forward_m,
                                double right) {
    return transform(T_start_robot, {scan.camera_m.x() + forward_m, scan.camera_m.y() - right * forward_m});
}

/// (forward, right) of a place, seen from the camera at T_start_robot.
inline Eigen::Vector2d seen_from(const ContactScan& scan, const Pose2& T_start_robot,
                                 const Eigen::Vector2d& place_m) {
    const Eigen::Vector2d p = transform(inverse(T_start_robot), place_m);
    return {p.x() - scan.camera_m.x(), scan.camera_m.y() - p.y()};
}

}  // namespace flownav::obstacles
