#pragma once

#include <string>

#include "nav_options.h"

namespace flownav {

/// result.json: what came out of a drive, and of what.
std::string result_json(const NavOptions& options, const DriveResult& result);

/// BARN's score of one run; 0 unless the goal was reached.
double barn_score(const DriveResult& result, double reference_path_m);

/// One row of drive.csv a decision of the navigator; the header names the columns.
std::string drive_csv_header();
std::string drive_csv_row(const DriveSample& sample, const nav::Autopilot& autopilot);

}  // namespace flownav
