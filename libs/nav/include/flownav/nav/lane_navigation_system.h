#pragma once

#include <mrpt/nav/reactive/CWaypointsNavigator.h>

#include <memory>

#include "flownav/nav/grid_robot.h"
#include "flownav/nav/lanes.h"

namespace flownav::nav {

class LaneLog;

/// choose_lane() as one of MRPT's navigators, a sibling of CReactiveNavigationSystem: single targets and way
/// points, states, events and watchdog are those of CWaypointsNavigator.
class CLaneNavigationSystem : public mrpt::nav::CWaypointsNavigator {
  public:
    /// The robot must outlive it. `navlog_dir`: where files for navlog-viewer go; empty: none.
    CLaneNavigationSystem(GridRobot& robot, LaneTables tables, const LaneParams& params,
                          const std::string& navlog_dir = "");
    ~CLaneNavigationSystem() override;
    CLaneNavigationSystem(const CLaneNavigationSystem&) = delete;
    CLaneNavigationSystem& operator=(const CLaneNavigationSystem&) = delete;

    void initialize() override {}

    /// Of the last step; lanes are empty before the first one.
    const LaneDecision& last_decision() const { return decision_; }

  protected:
    void performNavigationStep() override;
    bool impl_waypoint_is_reachable(const mrpt::math::TPoint2D& waypoint_robot_m) const override;

  private:
    GridRobot& grid_robot_;
    LaneTables tables_;
    LaneParams params_;
    LaneDecision decision_;
    std::unique_ptr<LaneLog> log_;
};

}  // namespace flownav::nav
