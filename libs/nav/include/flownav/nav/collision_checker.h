#pragma once

#include <Eigen/Core>
#include <deque>
#include <vector>

#include "flownav/core/pose2.h"
#include "flownav/core/robot_model.h"
#include "flownav/nav/ground_memory.h"
#include "flownav/nav/guard_params.h"
#include "flownav/nav/stopping_path.h"

namespace flownav::nav {

struct ContactRule;

/// Occupied cell near the robot.
struct NearObstacle {
    Eigen::Vector2d at_m = Eigen::Vector2d::Zero();  ///< robot frame
    double distance_m = 0.0;  ///< from the footprint; < 0: a little inside it, as a map is not exact
};

/// Pose and motion of the robot, and the obstacles near it.
struct Surroundings {
    double time_s = 0.0;
    Pose2 T_map_robot;
    MotionCommand motion;
    std::vector<NearObstacle> obstacles;  ///< within reach
    double nearest_m = 0.0;               ///< the least distance of those outside the footprint
};

/// Result of a command that is followed by a stop.
struct Forecast {
    bool touches = false;
    bool unseen = false;
    bool unscanned = false;    ///< ... and no contact scan looked at the unseen ground
    bool unconfirmed = false;  ///< ground on the way was in view and is no floor
    /// Ground on the way was seen, but is not known to be floor; asked of fast commands only.
    bool unproven = false;
    Eigen::Vector2d where_m = Eigen::Vector2d::Zero();  ///< the obstacle, robot frame
};

/// Checks the path of the robot until it stands, against obstacles and unseen ground.
class CollisionChecker {
  public:
    CollisionChecker(const RobotModel& robot, const CollisionCheckerParams& params, double cell_m);

    Surroundings look(const GroundMemory& ground, double time_s, const Pose2& T_map_robot,
                      const MotionCommand& motion) const;

    /// `sent`: the commands before; the candidate is in force for `hold_s`.
    Forecast forecast(const GroundMemory& ground, const Surroundings& now,
                      const std::deque<TimedCommand>& sent, const MotionCommand& candidate,
                      double hold_s) const;

    /// Upper bound of the speed of the fastest point of the outline.
    double outline_mps(const MotionCommand& command) const;

  private:
    double reach_m(const MotionCommand& motion) const;
    ContactRule rule_for(const Surroundings& now, const MotionCommand& candidate) const;
    bool touches(const Surroundings& now, const Pose2& T_robot_then, const ContactRule& rule,
                 Eigen::Vector2d& where_m) const;
    template <class Holds>
    bool holds_under_outline(const Surroundings& now, const std::vector<Pose2>& path, double most_m,
                             const Holds& holds) const;

    RobotModel robot_;
    CollisionCheckerParams params_;
    double cell_m_;
    double radius_m_;                         ///< of the circle about the footprint
    std::vector<Eigen::Vector2d> outline_m_;  ///< points all around the footprint, a little inside
};

}  // namespace flownav::nav
