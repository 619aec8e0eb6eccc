#pragma once

#include <mrpt/nav/reactive/CWaypointsNavigator.h>

#include <memory>

#include "flownav/nav/grid_robot.h"
#include "flownav/nav/lanes.h"

namespace flownav::nav {

class LaneLog;

/// choose_lane() as an MRPT navigator, a sibling of CReactiveNavigationSystem. Single targets, way points,
/// states, events and watchdog are inherited from CWaypointsNavigator.
class CLaneNavigationSystem : public mrpt::nav::CWaypointsNavigator {
  public:
    /// The robot must outlive this object. `navlog_dir`: folder of the files for navlog-viewer; empty: none.
    CLaneNavigationSystem(GridRobot& robot, LaneTables tables, const LaneParams& params,
                          const std::string& navlog_dir = "");
    ~CLaneNavigationSystem() override;
    CLaneNavigationSystem(const CLaneNavigationSystem&) = delete;
    CLaneNavigationSystem& operator=(const CLaneNavigationSystem&) = delete;

    void initialize() override {}

    /// Decision of the last step; its lanes are empty before the first one.
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
