#pragma once

#include "flownav/mapping/occupancy_limits.h"

namespace flownav::nav {

/// When a way to the goal is planned on the map of everything seen so far.
enum class ReplanPolicy {
    Always,     ///< the navigator follows a plan
    WhenStuck,  ///< it drives straight at the goal, and follows a plan after it was stuck
    Never,      ///< it drives straight at the goal
};

/// When a robot counts as arrived or stuck, and how far its recoveries go.
struct RecoveryParams {
    ReplanPolicy replan = ReplanPolicy::Always;
    mapping::OccupancyLimits limits;  ///< of the maps
    double goal_radius_m = 0.3;       ///< arrived when this near
    double stuck_s = 0.8;             ///< a recovery begins when the navigator sees no way for so long
    double held_s = 1.5;         ///< a recovery begins when a robot that wants to move stands for so long
    double no_progress_s = 6.0;  ///< a recovery begins when the robot comes no nearer for so long
    double back_off_m = 0.35;    ///< length of backing off; ends earlier where the ground is not known
    double creep_on_m = 0.2;     ///< length of creeping on
    double creep_mps = 0.08;     ///< speed of creeping on; below the guard's crawl speed
    double look_rad = 0.9;       ///< angle of looking to either side
    double away_rad = 0.5;       ///< turn of a follower away from its way point
    double turn_radps = 0.5;     ///< turn rate of recoveries; at most the robot's
    int recoveries_max = 20;     ///< recoveries without progress before the robot is blocked
};

}  // namespace flownav::nav
