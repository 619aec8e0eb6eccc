#include "flownav/nav/lane_navigation_system.h"
#include "reactive/mrpt_step.h"
#include "recovery/navigators.h"

namespace flownav::nav {
namespace {

LaneParams params_of(const NavigatorOptions& options) {
    LaneParams params = options.lanes;
    params.period_s = options.period_s;
    return params;
}

LaneTables tables_of(const NavigatorOptions& options) {
    LaneLayout layout = options.layout;
    layout.map_size_m = options.map_size_m;
    layout.resolution_m = options.resolution_m;
    return make_lane_tables(options.robot, layout);
}

class LaneNavigator : public Navigator {
  public:
    explicit LaneNavigator(const NavigatorOptions& options)
        : robot_(options.robot, options.lanes.limits, 0.0, options.watchdog),
          system_(robot_, tables_of(options), params_of(options), options.navlog_dir) {
        set_verbosity(system_, options.verbose);
    }

    Decision decide(const Situation& situation, const Eigen::Vector2d& waypoint_m) override {
        if (!step(system_, robot_, situation, waypoint_m)) return at_way_point();
        const LaneDecision& lanes = system_.last_decision();
        return {robot_.command(), lanes.way.occupied, lanes.stuck, lanes.why};
    }

  private:
    GridRobot robot_;
    CLaneNavigationSystem system_;
};

}  // namespace

std::unique_ptr<Navigator> make_lane_navigator(const NavigatorOptions& options) {
    return std::make_unique<LaneNavigator>(options);
}

}  // namespace flownav::nav
