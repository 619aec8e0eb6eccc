#pragma once

#include <memory>
#include <string>

#include "flownav/core/navigation_params.h"
#include "flownav/nav/lanes.h"
#include "flownav/nav/navigator.h"
#include "flownav/nav/watchdog_sink.h"

namespace flownav::nav {

struct NavigatorOptions {
    NavigatorKind kind = NavigatorKind::Lanes;
    RobotModel robot;
    double map_size_m = 10.0;          ///< of the local maps it will see
    double resolution_m = 0.1;         ///< of their cells
    double period_s = 0.2;             ///< between two decisions
    LaneParams lanes;                  ///< its limits of cells and its caution hold for both kinds
    LaneLayout layout;                 ///< its map is ignored: map_size_m and resolution_m above count
    std::string navlog_dir;            ///< where navlog-viewer's files go; empty: none
    std::string ptg_cache_dir;         ///< where Reactive keeps its tables between runs; empty: nowhere
    bool verbose = false;              ///< MRPT may write to the console
    WatchdogSink* watchdog = nullptr;  ///< outlives the navigator
};

/// Takes up to a second: tables are built. When MRPT's clock is simulated, the navigator sets it to the time
/// of each situation. Throws std::invalid_argument (options that make no sense), std::runtime_error (the
/// folder of the navlog cannot be made).
std::unique_ptr<Navigator> make_navigator(const NavigatorOptions& options);

}  // namespace flownav::nav
