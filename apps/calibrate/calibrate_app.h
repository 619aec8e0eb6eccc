#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace flownav {

/// flownav-calibrate: estimates the pose of a camera from a drive. `arguments` begin with the program's name.
/// Returns the exit status: 0 fine, 1 bad usage or configuration, 2 damaged input, 3 output could not be
/// written, 4 the drive does not determine the pose.
int run_calibrate_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error);

}  // namespace flownav
