#pragma once
#include <vector>

#include "flownav/replay/drive.h"
#include "flownav/replay/svg_chart.h"

namespace flownav {

/// The charts of a drive: trajectory, heading, turn rate, forward speed, counts, and with ground truth the
/// distance from it. Times count from the first field; poses start at the identity.
std::vector<Chart> charts_of(const Drive& drive);

/// A band over time, as an <svg> element: which fields had which status.
std::string status_band(const std::vector<FieldRow>& rows);

/// The colour of a status, as in CSS.
const char* colour_of(FieldStatus status);

}  // namespace flownav
