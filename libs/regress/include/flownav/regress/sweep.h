#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flownav/regress/run_results.h"

namespace flownav::regress {

/// One parameter and the values to try.
struct SweepAxis {
    std::string key;  ///< section.key
    std::vector<std::string> values;
};

/// One combination of values.
struct SweepPoint {
    std::vector<std::string> values;    ///< one of each axis
    std::vector<std::string> settings;  ///< section.key=value
    std::string name;                   ///< of its folder: the settings, apart by commas
};

/// The axes of --set section.key=a,b,c. Throws UsageError for a setting of another form, an empty value or
/// one that is no part of a file name, a value twice, a key twice.
std::vector<SweepAxis> sweep_axes(const std::vector<std::string>& settings);

/// Every combination, the last axis changing fastest. Throws UsageError when there are more than 10000.
std::vector<SweepPoint> sweep_points(const std::vector<SweepAxis>& axes);

/// What a sweep found.
struct SweepResults {
    std::vector<SweepAxis> axes;
    std::vector<SweepPoint> points;
    std::vector<RunResults> runs;  ///< one a point
};

/// A row a point and rawlog: the value of each axis, then what merged.csv has.
std::string sweep_csv(const SweepResults& sweep);

/// A page that opens offline: any figure over any one or two of the parameters, as heat map and curves.
std::string sweep_html(const SweepResults& sweep);

}  // namespace flownav::regress
