#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/nav/reactive/CReactiveNavigationSystem.h>

#include <algorithm>
#include <cmath>

#include "speed_limiter.h"
#include "mrpt_step.h"
#include "reactive_config.h"
#include "recovery/navigators.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double standing = 0.02;  // m/s or rad/s: so little is no command to go

/// CReactiveNavigationSystem that does not write statistics to the console at its end.
class ReactiveSystem : public mrpt::nav::CReactiveNavigationSystem {
  public:
    ReactiveSystem(GridRobot& robot, const NavigatorOptions& options)
        : CReactiveNavigationSystem(robot, options.verbose, false, options.navlog_dir) {
        set_verbosity(*this, options.verbose);
        const mrpt::config::CConfigFileMemory config(reactive_config(options));
        loadConfigFile(config);
        // Not read from the ini. A folder that cannot be written to keeps nothing.
        params_abstract_ptg_navigator.ptg_cache_files_directory =
            options.ptg_cache_dir.empty() ? "/dev/null" : options.ptg_cache_dir;
        initialize();
        if (!options.navlog_dir.empty()) enableLogFile(true);
    }
    ~ReactiveSystem() override { m_timlog_delays.clear(true); }
    ReactiveSystem(const ReactiveSystem&) = delete;
    ReactiveSystem& operator=(const ReactiveSystem&) = delete;
};

class ReactiveNavigator : public Navigator {
  public:
    explicit ReactiveNavigator(const NavigatorOptions& options)
        : caution_(options.robot, options.lanes, options.period_s),
          robot_(options.robot, options.lanes.limits, reactive_margin_m, options.watchdog),
          system_(robot_, options) {}

    Decision decide(const Situation& situation, const Vector2d& waypoint_m) override {
        const Vector2d there = transform(inverse(situation.T_map_robot), waypoint_m);
        if (situation.obstacles_known && caution_.wants_to_turn(there, situation.motion)) {
            Decision turn = caution_.turn_to(situation, there);
            if (!turn.stuck) return turn;
        }
        // MRPT knows no target beyond its range.
        const Vector2d near = there * std::min(1.0, 0.9 * reactive_range_m / std::max(1e-6, there.norm()));
        if (!step(system_, robot_, situation, transform(situation.T_map_robot, near))) return at_way_point();
        if (!situation.obstacles_known) return {{}, 0.0, false, "obstacles are not known"};
        const MotionCommand wanted = robot_.command();
        const bool stands = std::hypot(wanted.v_mps, wanted.omega_radps) < standing;
        if (robot_.emergency_stop() || stands) return {{}, 0.0, true, "no path is free"};
        return caution_.limit(situation, wanted);
    }

  private:
    SpeedLimiter caution_;
    GridRobot robot_;
    ReactiveSystem system_;
};

}  // namespace

std::unique_ptr<Navigator> make_reactive_navigator(const NavigatorOptions& options) {
    return std::make_unique<ReactiveNavigator>(options);
}

}  // namespace flownav::nav
