#include "flownav/report/contact_segments.h"

namespace flownav::report {

std::vector<ContactSegment> contact_segments(const ContactScan& scan, const Pose2& T_map_robot) {
    std::vector<ContactSegment> segments;
    if (scan.gate != ContactGate::Open) return segments;
    for (std::size_t i = 0; i < scan.strips.size(); ++i) {
        const ContactStrip& strip = scan.strips[i];
        if (strip.kind != BeamKind::Obstacle) continue;
        const double middle = middle_tangent(scan, static_cast<int>(i));
        const auto at = [&](double right, double forward_m) {
            return transform(T_map_robot, point_of(scan, right, forward_m));
        };
        segments.push_back({at(middle + scan.step / 2, strip.contact_m),
                            at(middle - scan.step / 2, strip.contact_m), at(middle, strip.near_m),
                            at(middle, strip.far_m), strip.cause});
    }
    return segments;
}

}  // namespace flownav::report
