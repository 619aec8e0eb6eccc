#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flownav/regress/run_results.h"

namespace flownav::regress {

/// One parameter and its values.
struct SweepAxis {
    std::string key;  ///< section.key
    std::vector<std::string> values;
};

/// One combination of values.
struct SweepPoint {
    std::vector<std::string> values;    ///< one per axis
    std::vector<std::string> settings;  ///< section.key=value
    std::string name;                   ///< name of its folder: the settings, separated by commas
};

/// Parses the axes from --set section.key=a,b,c. Throws UsageError for a setting of another form, an empty
/// value, a value that cannot be part of a file name, or a repeated value or key.
std::vector<SweepAxis> sweep_axes(const std::vector<std::string>& settings);

/// Returns every combination, the last axis changing fastest. Throws UsageError for more than 10000.
std::vector<SweepPoint> sweep_points(const std::vector<SweepAxis>& axes);

/// Results of a sweep.
struct SweepResults {
    std::vector<SweepAxis> axes;
    std::vector<SweepPoint> points;
    std::vector<RunResults> runs;  ///< one per point
};

/// CSV with one row per point and rawlog: the value of each axis, then the columns of merged.csv.
std::string sweep_csv(const SweepResults& sweep);

/// Builds a page that opens offline: any figure over one or two of the parameters, as heat map and curves.
std::string sweep_html(const SweepResults& sweep);

}  // namespace flownav::regress
