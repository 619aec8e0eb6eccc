#pragma once

#include <string>

#include "nav_options.h"

namespace flownav {

/// result.json: what came out of a drive, and of what.
std::string result_json(const NavOptions& options, const drive::DriveResult& result, int fields_left_out);

/// BARN's score of one run; 0 unless the goal was reached.
double barn_score(const drive::DriveResult& result, double reference_path_m);

}  // namespace flownav
