#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace flownav {

/// flownav-import: converts data sets, pictures and videos to rawlogs. `arguments` begin with the program's
/// name. Returns the exit status: 0 fine, 1 bad usage or configuration or no such data set, 2 part of the
/// input could not be read, 3 output could not be written.
int run_import_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error);

}  // namespace flownav
