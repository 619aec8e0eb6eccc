#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace flownav {

/// The program flownav-regress: arguments (the first is the program's name) to exit status.
int run_regress_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error);

}  // namespace flownav
