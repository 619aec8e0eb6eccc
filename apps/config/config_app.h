#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace flownav {

/// flownav-config: prints, checks and documents the configuration.
/// `arguments` begin with the program's name. Returns the exit status: 0 fine, 1 bad usage or configuration.
int run_config_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error);

}  // namespace flownav
