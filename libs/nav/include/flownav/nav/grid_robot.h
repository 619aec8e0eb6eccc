#pragma once

#include <mrpt/nav/reactive/CRobot2NavInterface.h>

#include <string>

#include "flownav/nav/collision_free_distance.h"
#include "flownav/nav/navigator.h"
#include "flownav/nav/watchdog_sink.h"

namespace flownav::nav {

/// The robot as MRPT's navigators see it: takes a situation, returns a command, moves no hardware. Obstacles
/// are the occupied cells of the local map, except those that touch the footprint already; the caller must
/// keep the robot from approaching these. Without known obstacles senseObstacles() fails and the navigator
/// stops.
class GridRobot : public mrpt::nav::CRobot2NavInterface {
  public:
    /// `margin_m`: cells nearer to the footprint are left out. `watchdog` may be null.
    GridRobot(const RobotModel& robot, const mapping::OccupancyLimits& limits, double margin_m,
              WatchdogSink* watchdog);

    /// The map of the situation must live until the next call.
    void see(const Situation& situation);
    const Situation& situation() const { return situation_; }

    /// The navigator's last command since see(); it holds until the next one.
    const MotionCommand& command() const { return command_; }
    /// True when the navigator stopped because it found no way or had no obstacle data.
    bool emergency_stop() const { return emergency_stop_; }

    bool getCurrentPoseAndSpeeds(mrpt::math::TPose2D& pose, mrpt::math::TTwist2D& velocity_map,
                                 mrpt::system::TTimeStamp& timestamp, mrpt::math::TPose2D& odometry,
                                 std::string& frame_id) override;
    bool changeSpeeds(const mrpt::kinematics::CVehicleVelCmd& command) override;
    bool changeSpeedsNOP() override;
    bool stop(bool is_emergency) override;
    mrpt::kinematics::CVehicleVelCmd::Ptr getEmergencyStopCmd() override;
    mrpt::kinematics::CVehicleVelCmd::Ptr getStopCmd() override;
    mrpt::kinematics::CVehicleVelCmd::Ptr getAlignCmd(double heading_rad) override;
    bool startWatchdog(float period_ms) override;
    bool stopWatchdog() override;
    bool senseObstacles(mrpt::maps::CSimplePointsMap& obstacles,
                        mrpt::system::TTimeStamp& timestamp) override;
    double getNavigationTime() override { return situation_.time_s; }
    void resetNavigationTimer() override {}

    // MRPT's defaults write to the console.
    void sendNavigationStartEvent() override {}
    void sendNavigationEndEvent() override {}
    void sendWaypointReachedEvent(int, bool) override {}
    void sendNewWaypointTargetEvent(int) override {}
    void sendNavigationEndDueToErrorEvent() override {}
    void sendWaySeemsBlockedEvent() override {}
    void sendApparentCollisionEvent() override {}
    void sendCannotGetCloserToBlockedTargetEvent() override {}

  private:
    RobotModel robot_;
    mapping::OccupancyLimits limits_;
    double margin_m_;
    FootprintField field_;
    WatchdogSink* watchdog_;
    Situation situation_;
    MotionCommand command_;
    bool emergency_stop_ = false;
};

}  // namespace flownav::nav
