#pragma once
#include <Eigen/Core>
#include <vector>

#include "flownav/core/contact_scan.h"

namespace flownav::report {

/// Where a strip of a contact scan ends at an obstacle, seen from above.
struct ContactSegment {
    Eigen::Vector2d right_m, left_m;  ///< ends of the contact, as wide as the strip
    Eigen::Vector2d near_m, far_m;    ///< ends of its interval, in the middle of the strip
    BeamCause cause = BeamCause::None;
};

/// The contacts of a scan in the frame of a map or of the robot; `T_map_robot` is the pose of the robot to
/// whose frame the scan belongs. Empty for a closed gate.
std::vector<ContactSegment> contact_segments(const ContactScan& scan, const Pose2& T_map_robot);

}  // namespace flownav::report
