#pragma once
#include <Eigen/Core>
#include <vector>

#include "flownav/core/contact_scan.h"

namespace flownav::obstacles {

constexpr double drop_excess_px =
    -2.0;  ///< a block whose vector is so much shorter than that of the floor is short
constexpr double drop_range_m = 3.5;  ///< of the floor point of a short block

/// Enters a drop into every strip that shows the end of the floor: four short blocks close together in front
/// of it. `short_blocks`: floor points of the blocks, (forward, right) from the camera of the scan. The drop
/// begins where the confirmed floor of the strip ends. Sorts `buffer`.
void mark_drops(const std::vector<Eigen::Vector2d>& short_blocks, std::vector<double>& buffer,
                ContactScan& scan);

}  // namespace flownav::obstacles
