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

/// Reads the observations of a rawlog by label, in their order; fails the test unless the rawlog ends clean.
ByLabel observations_of(const std::filesystem::path& rawlog);

std::map<std::string, std::size_t> counts(const ByLabel& observations);

/// Largest differences between the observations of two rawlogs.
struct Differences {
    double time_s = 0.0, omega_radps = 0.0, v_mps = 0.0, position_m = 0.0, heading_rad = 0.0;
    double range_m = 0.0, point_m = 0.0;
    int validity = 0, beams = 0, points = 0;  ///< counts of mismatches
    int other_beams = 0;  ///< beams that ended elsewhere: not in range_m, and not in validity
};

/// Compares the observations with the labels of `expected` one by one; fails the test when their numbers
/// differ.
Differences compared(const ByLabel& found, const ByLabel& expected);

std::ostream& operator<<(std::ostream& out, const Differences& d);

}  // namespace flownav::testing
