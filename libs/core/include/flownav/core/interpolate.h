#pragma once
#include "flownav/core/pose2.h"

namespace flownav {

/// Pose at `share` of the way from `a` to `b`, share 0..1: on the straight line, at constant turn rate. A
/// share outside 0..1 goes on beyond them.
inline Pose2 interpolated(const Pose2& a, const Pose2& b, double share) {
    const Pose2 T_a_b = compose(inverse(a), b);
    return compose(a, {share * T_a_b.x_m, share * T_a_b.y_m, share * T_a_b.yaw_rad});
}

}  // namespace flownav
