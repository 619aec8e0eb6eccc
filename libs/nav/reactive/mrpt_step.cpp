#include "mrpt_step.h"

namespace flownav::nav {
namespace {

constexpr float reached_m = 0.05F;  // when a goal is reached is not for the local navigator to say

}  // namespace

bool step(mrpt::nav::CWaypointsNavigator& system, GridRobot& robot, const Situation& situation,
          const Eigen::Vector2d& waypoint_m) {
    if (mrpt::Clock::getActiveClock() == mrpt::Clock::Simulated)
        mrpt::Clock::setSimulatedTime(mrpt::Clock::fromDouble(situation.time_s));
    robot.see(situation);
    // A new target while navigating stops nothing; one that is reached or failed starts anew.
    mrpt::nav::CWaypointsNavigator::TNavigationParamsWaypoints request;
    request.target.target_coords = {waypoint_m.x(), waypoint_m.y(), 0.0};
    request.target.targetAllowedDistance = reached_m;
    request.target.targetDesiredRelSpeed = 0.2;
    system.navigate(&request);
    system.navigationStep();
    return system.getCurrentState() != mrpt::nav::CAbstractNavigator::IDLE;
}

Decision at_way_point() {
    return {{}, 0.0, false, "at the way point"};
}

void set_verbosity(mrpt::nav::CWaypointsNavigator& system, bool verbose) {
    system.setMinLoggingLevel(verbose ? mrpt::system::LVL_INFO : mrpt::system::LVL_ERROR);
    system.logging_enable_console_output = verbose;
    system.enableRethrowNavExceptions(true);
}

}  // namespace flownav::nav
