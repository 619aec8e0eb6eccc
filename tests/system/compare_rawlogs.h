#pragma once
#include <mrpt/obs/CObservation.h>

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace flownav::testing {

using ByLabel = std::map<std::string, std::vector<mrpt::obs::CObservation::Ptr>>;

/// The observations of a rawlog in their order; a test failure when it does not end clean.
ByLabel observations_of(const std::filesystem::path& rawlog);

std::map<std::string, std::size_t> counts(const ByLabel& observations);

/// Largest differences between the observations of two rawlogs.
struct Differences {
    double time_s = 0.0, omega_radps = 0.0, v_mps = 0.0, position_m = 0.0, heading_rad = 0.0;
    double range_m = 0.0, point_m = 0.0;
    int validity = 0, beams = 0, points = 0;  ///< that do not agree
};

/// Observation by observation, those labelled as in `expected`; a test failure when the numbers differ.
Differences compared(const ByLabel& found, const ByLabel& expected);

std::ostream& operator<<(std::ostream& out, const Differences& d);

}  // namespace flownav::testing
