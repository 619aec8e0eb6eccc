#pragma once
#include <string>
#include <vector>

#include "flownav/calibration/calibration.h"

namespace flownav::calibration {

/// Text of the ini of a calibrated camera: all values that `given` sets, and the determined values with a
/// comment about their uncertainty. `header`: lines of comment at the top.
std::string calibration_ini(const config::Config& given, const std::vector<CalibratedValue>& values,
                            const std::vector<std::string>& header);

}  // namespace flownav::calibration
