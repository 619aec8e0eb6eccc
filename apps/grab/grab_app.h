#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "flownav/cli/stop_signals.h"

namespace flownav {

/// Runs flownav-grab; the first argument is the program's name. Returns the exit status. When a driver hangs,
/// exits the process instead, with the recording complete.
int run_grab_app(const std::vector<std::string>& arguments, const cli::StopSignals& signals,
                 std::ostream& out, std::ostream& error);

}  // namespace flownav
