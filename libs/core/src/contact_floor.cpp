#include "flownav/core/contact_floor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flownav {
namespace {

using Eigen::Vector2d;

constexpr double going_on_ratio = 1.3;  // of the ranges of neighbouring strips on one wall

const ContactStrip& strip_at(const ContactScan& scan, int i) {
    return scan.strips[static_cast<std::size_t>(i)];
}

bool has_strip(const ContactScan& scan, int i) {
    return i >= 0 && i < static_cast<int>(scan.strips.size());
}

double left_tangent(const ContactScan& scan, int i) {
    return (scan.first + i) * scan.step;
}

/// Forward distance at which an obstacle is drawn: its best estimate; of a drop the end of the floor.
double begin_m(const ContactStrip& strip) {
    return strip.cause == BeamCause::Drop ? strip.near_m : strip.contact_m;
}

/// The end of a line of strip `i` toward strip `j`, its neighbour. `tangent`: of the border between them.
Vector2d end_toward(const ContactScan& scan, int i, int j, double tangent) {
    const ContactStrip& strip = strip_at(scan, i);
    const Vector2d border_m = point_of(scan, tangent, begin_m(strip));
    if (!has_strip(scan, j)) return border_m;
    const ContactStrip& other = strip_at(scan, j);
    const bool is_long = strip.cause == BeamCause::Wall || strip.cause == BeamCause::Drop;
    const bool is_same = other.kind == BeamKind::Obstacle && other.cause == strip.cause;
    const double ratio = std::max(begin_m(strip), begin_m(other)) / std::min(begin_m(strip), begin_m(other));
    if (!is_long || !is_same || !(ratio < going_on_ratio)) return border_m;
    return (point_of(scan, middle_tangent(scan, i), begin_m(strip)) +
            point_of(scan, middle_tangent(scan, j), begin_m(other))) /
           2;
}

/// Forward distance up to which a strip may be Unconfirmed.
double looked_to_m(const ContactScan& scan, int i, double unconfirmed_to_m) {
    return strip_at(scan, i).seen ? std::min(unconfirmed_to_m, seen_to_m(scan, i)) : 0.0;
}

}  // namespace

double seen_to_m(const ContactScan& scan, int i) {
    double nearest_m = std::numeric_limits<double>::infinity();
    for (int k = i - 1; k <= i + 1; ++k) {
        if (has_strip(scan, k) && strip_at(scan, k).kind == BeamKind::Obstacle)
            nearest_m = std::min(nearest_m, strip_at(scan, k).near_m);
    }
    return nearest_m;
}

double floor_to_m(const ContactScan& scan, int i) {
    const ContactStrip& strip = strip_at(scan, i);
    if (strip.kind == BeamKind::Unknown) return 0.0;
    const double to_m = std::min(strip.free_m, seen_to_m(scan, i));
    return to_m > scan.view_near_m ? to_m : 0.0;
}

FloorSight floor_at(const ContactScan& scan, double forward_m, double right_m, double half_m,
                    double unconfirmed_to_m) {
    if (!(forward_m >= scan.view_near_m) || forward_m <= 0.0) return FloorSight::NotSeen;
    const double strip = std::floor(right_m / forward_m / scan.step) - scan.first;
    if (!(strip >= 0.0 && strip < static_cast<double>(scan.strips.size()))) return FloorSight::NotSeen;
    const int i = static_cast<int>(strip);
    if (forward_m + half_m <= floor_to_m(scan, i)) return FloorSight::Confirmed;
    return forward_m < looked_to_m(scan, i, unconfirmed_to_m) ? FloorSight::Unconfirmed : FloorSight::NotSeen;
}

double floor_share(const ContactScan& scan) {
    int seen = 0;
    int floor = 0;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        if (!strip_at(scan, i).seen || strip_at(scan, i).kind == BeamKind::Obstacle) continue;
        ++seen;
        floor += strip_at(scan, i).kind == BeamKind::Free;
    }
    return seen > 0 ? static_cast<double>(floor) / seen : 0.0;
}

Eigen::AlignedBox2d floor_bounds(const ContactScan& scan, const Pose2& T_frame_robot,
                                 double unconfirmed_to_m) {
    Eigen::AlignedBox2d bounds;
    if (scan.gate != ContactGate::Open || !(scan.view_near_m >= 0.0)) return bounds;
    for (int i = 0; i < static_cast<int>(scan.strips.size()); ++i) {
        const double to_m = std::max(floor_to_m(scan, i), looked_to_m(scan, i, unconfirmed_to_m));
        if (!(to_m > scan.view_near_m)) continue;
        for (const double tangent : {left_tangent(scan, i), left_tangent(scan, i + 1)})
            for (const double forward_m : {scan.view_near_m, to_m})
                bounds.extend(transform(T_frame_robot, point_of(scan, tangent, forward_m)));
    }
    return bounds;
}

ContactLine line_of(const ContactScan& scan, int i) {
    return {end_toward(scan, i, i - 1, left_tangent(scan, i)),
            point_of(scan, middle_tangent(scan, i), begin_m(strip_at(scan, i))),
            end_toward(scan, i, i + 1, left_tangent(scan, i + 1))};
}

}  // namespace flownav
