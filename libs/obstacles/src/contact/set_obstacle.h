#pragma once
#include <algorithm>

#include "flownav/core/contact_scan.h"

namespace flownav::obstacles {

inline void set_obstacle(ContactStrip& strip, BeamCause cause, double forward_m, double near_m,
                         double far_m) {
    strip.kind = BeamKind::Obstacle;
    strip.cause = cause;
    strip.contact_m = forward_m;
    strip.near_m = std::min(near_m, forward_m);
    strip.far_m = std::max(far_m, forward_m);
}

}  // namespace flownav::obstacles
