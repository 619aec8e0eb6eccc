#pragma once
#include <vector>

#include "flownav/replay/drive.h"
#include "flownav/replay/svg_chart.h"

namespace flownav {

/// The charts of a drive: trajectory, heading, turn rate, forward speed, counts. Times count from the first
/// field; poses start at the identity.
std::vector<Chart> charts_of(const Drive& drive);

}  // namespace flownav
