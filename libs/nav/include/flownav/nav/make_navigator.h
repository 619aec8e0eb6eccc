#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "flownav/core/robot_model.h"
#include "flownav/nav/lanes.h"
#include "flownav/nav/navigator.h"
#include "flownav/nav/watchdog_sink.h"

namespace flownav::nav {

struct NavigatorOptions {
    RobotModel robot;
    double map_size_m = 10.0;          ///< of the local maps it will see
    double resolution_m = 0.1;         ///< of their cells
    double period_s = 0.2;             ///< between two decisions
    LaneParams lanes;                  ///< its limits of cells and its caution hold for every navigator
    LaneLayout layout;                 ///< its map is ignored: map_size_m and resolution_m above count
    std::string navlog_dir;            ///< folder of the files for navlog-viewer; empty: none
    std::string ptg_cache_dir;         ///< folder of the tables that `reactive` reuses; empty: none
    bool verbose = false;              ///< MRPT may write to the console
    WatchdogSink* watchdog = nullptr;  ///< outlives the navigator
};

using NavigatorFactory = std::function<std::unique_ptr<Navigator>(const NavigatorOptions&)>;

/// Adds a navigator, which `navigation.navigator = name` then selects. "lanes" (circular lanes over the local
/// map) and "reactive" (MRPT's CReactiveNavigationSystem) are built in. Call it before the configuration is
/// read. Throws std::invalid_argument: no factory, or a name that is taken or holds other characters than
/// a-z, 0-9 and _.
void register_navigator(const std::string& name, NavigatorFactory factory);

/// Makes the navigator of a name. The built-in ones take up to a second to build their tables, and set MRPT's
/// clock, when that is simulated, to the time of each situation. Throws std::invalid_argument (an unknown
/// name: the text lists the known ones; options that contradict each other), std::runtime_error (the folder
/// of the navlog cannot be made).
std::unique_ptr<Navigator> make_navigator(const std::string& name, const NavigatorOptions& options);

/// Names of all navigators, in the order of their registration.
std::vector<std::string> navigator_names();

}  // namespace flownav::nav
