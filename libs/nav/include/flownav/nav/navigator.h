#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <Eigen/Core>
#include <optional>
#include <string>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"

namespace flownav::nav {

/// The input of a decision. All poses are in the frame of the robot's odometry, called
/// `map` here. Cells speak of the probability of being FREE; 0.5 is unknown.
struct Situation {
    double time_s = 0.0;
    Pose2 T_map_robot;
    MotionCommand motion;                                        ///< how the robot moves now
    const mrpt::maps::COccupancyGridMap2D* local_map = nullptr;  ///< robot frame, robot in the middle
    bool obstacles_known = true;   ///< false: the sensor is stale or blind, no step into the unseen
    bool stop_at_waypoint = true;  ///< false: the way point is on the way to others, no need to slow down
};

/// The output of a decision.
struct Decision {
    MotionCommand command;
    double free_m = 0.0;  ///< way along the commanded curve that is known to hold no obstacle
    bool stuck = false;   ///< no way toward the way point is open
    std::string why;      ///< reason in a few words, for the log
};

/// A local navigator: drives toward ONE way point around the obstacles of the local map. make_navigator.h has
/// the registry of navigators.
class Navigator {
  public:
    Navigator() = default;
    virtual ~Navigator() = default;
    Navigator(const Navigator&) = delete;
    Navigator& operator=(const Navigator&) = delete;

    /// Decides the next command on the way to `waypoint_m` (map frame). Called every 200 ms or so.
    virtual Decision decide(const Situation& situation, const Eigen::Vector2d& waypoint_m) = 0;
};

}  // namespace flownav::nav
