#pragma once
#include <ostream>
#include <string>
#include <vector>

namespace flownav {

/// Runs flownav-replay; the first argument is the program's name. Returns the exit status.
int run_replay_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error);

}  // namespace flownav
