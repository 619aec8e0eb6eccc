#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace flownav {

/// flownav-sim: records a drive through a simulated world.
/// `arguments` begin with the program's name. Returns the exit status: 0 fine, 1 bad usage or configuration,
/// 2 a world or a path could not be read, 3 output could not be written.
int run_sim_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error);

}  // namespace flownav
