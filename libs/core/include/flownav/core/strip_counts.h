#pragma once
#include <array>

#include "flownav/core/contact_scan.h"

namespace flownav {

/// Number of strips of a contact scan by their content.
struct StripCounts {
    static constexpr double decided_to_m = 2.0;

    int free = 0;
    int obstacle = 0;
    int unknown = 0;
    int in_view = 0;  ///< seen, or not unknown
    int decided = 0;  ///< of those in view: an obstacle within `decided_to_m`, or floor confirmed up to there
    std::array<int, all_beam_causes.size()> by_cause{};  ///< obstacles, in the order of BeamCause
};

StripCounts counts_of(const ContactScan& scan);

}  // namespace flownav
