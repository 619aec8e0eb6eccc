#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace flownav {

/// flownav-nav. Returns the exit status that --help documents.
int run_nav_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error);

}  // namespace flownav
