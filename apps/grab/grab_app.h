#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "flownav/cli/stop_signals.h"

namespace flownav {

/// The program flownav-grab: arguments (the first is the program's name) to exit status. Does not return
/// where a driver hangs: the program ends then, with the recording complete.
int run_grab_app(const std::vector<std::string>& arguments, const cli::StopSignals& signals,
                 std::ostream& out, std::ostream& error);

}  // namespace flownav
