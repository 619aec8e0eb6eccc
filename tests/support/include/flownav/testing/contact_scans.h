#pragma once
#include "flownav/core/contact_scan.h"

namespace flownav::testing {

/// A scan of 40 strips over 45 degrees to both sides that sees the floor from 0.4 m on and is sure of
/// nothing. Its camera is at the robot's axis.
inline ContactScan open_scan() {
    ContactScan scan;
    scan.gate = ContactGate::Open;
    scan.first = -20;
    scan.view_near_m = 0.4;
    ContactStrip strip;
    strip.seen = true;
    scan.strips.assign(40, strip);
    return scan;
}

/// Calls change(strip) for the strips whose middles lie between two tangents; > 0 is to the right.
template <class Change>
void change_strips(ContactScan& scan, double from, double to, const Change& change) {
    for (std::size_t i = 0; i < scan.strips.size(); ++i) {
        const double tangent = middle_tangent(scan, static_cast<int>(i));
        if (tangent > from && tangent < to) change(scan.strips[i]);
    }
}

/// Confirms the floor of strips up to a forward distance from the camera.
inline void confirm(ContactScan& scan, double from, double to, double free_m) {
    change_strips(scan, from, to, [free_m](ContactStrip& strip) {
        strip.kind = BeamKind::Free;
        strip.free_m = free_m;
    });
}

/// Puts an obstacle into strips: `near_m` is the near end of its interval. Keeps the floor before it.
inline void block(ContactScan& scan, double from, double to, double near_m,
                  BeamCause cause = BeamCause::Votes) {
    change_strips(scan, from, to, [near_m, cause](ContactStrip& strip) {
        strip.kind = BeamKind::Obstacle;
        strip.cause = cause;
        strip.near_m = near_m;
        strip.contact_m = 1.1 * near_m;
        strip.far_m = 1.2 * near_m;
    });
}

/// The same with the best estimate of the distance; the near end lies nearer by a tenth.
inline void block_at(ContactScan& scan, double from, double to, double contact_m,
                     BeamCause cause = BeamCause::Votes) {
    block(scan, from, to, contact_m / 1.1, cause);
}

/// A scan whose floor is confirmed up to `free_m` everywhere.
inline ContactScan free_scan(double free_m) {
    ContactScan scan = open_scan();
    confirm(scan, -1.0, 1.0, free_m);
    return scan;
}

}  // namespace flownav::testing
