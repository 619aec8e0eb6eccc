#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace flownav {

/// How a drive hears that it is to stop.
struct StopRequest {
    std::function<bool()> wanted;   ///< asked every tick; empty: never
    std::function<void()> release;  ///< called when the robot stands: a further signal may end the program
};

/// flownav-nav. Returns the exit status that --help documents.
int run_nav_app(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& error);
int run_nav_app(const std::vector<std::string>& arguments, const StopRequest& stop, std::ostream& out,
                std::ostream& error);

}  // namespace flownav
