#pragma once
#include <string>
#include <vector>

#include "flownav/calibration/calibration.h"

namespace flownav::calibration {

/// The ini of a calibrated camera: everything that `given` sets, with the determined values in place, each
/// under a comment. `header`: lines of comment at the top.
std::string calibration_ini(const config::Config& given, const std::vector<CalibratedValue>& values,
                            const std::vector<std::string>& header);

}  // namespace flownav::calibration
