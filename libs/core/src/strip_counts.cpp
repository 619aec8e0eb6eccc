#include "flownav/core/strip_counts.h"

namespace flownav {

namespace {

bool is_decided(const ContactStrip& strip) {
    const bool blocked = strip.kind == BeamKind::Obstacle && strip.contact_m < StripCounts::decided_to_m;
    return blocked || strip.free_m >= StripCounts::decided_to_m;
}

}  // namespace

StripCounts counts_of(const ContactScan& scan) {
    StripCounts counts;
    for (const ContactStrip& strip : scan.strips) {
        counts.free += strip.kind == BeamKind::Free ? 1 : 0;
        counts.obstacle += strip.kind == BeamKind::Obstacle ? 1 : 0;
        counts.unknown += strip.kind == BeamKind::Unknown ? 1 : 0;
        const bool in_view = strip.seen || strip.kind != BeamKind::Unknown;
        counts.in_view += in_view ? 1 : 0;
        counts.decided += in_view && is_decided(strip) ? 1 : 0;
        if (strip.kind == BeamKind::Obstacle) ++counts.by_cause.at(static_cast<std::size_t>(strip.cause));
    }
    return counts;
}

}  // namespace flownav
