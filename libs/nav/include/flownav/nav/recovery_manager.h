#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "flownav/nav/navigator.h"
#include "flownav/nav/planner.h"
#include "flownav/nav/recovery_params.h"

namespace flownav::nav {

/// State of the recovery manager.
enum class RecoveryState {
    Driving,       ///< the navigator drives to the way point
    TurningToWay,  ///< in place, toward the plan
    LookingLeft,   ///< in place
    LookingRight,  ///< in place, past the middle
    BackingOff,    ///< straight back, over ground that was seen or driven over
    CreepingOn,    ///< slowly straight on, out of a place where it can neither turn nor back off
    Arrived,       ///< standing at the goal (terminal state)
    Blocked,       ///< all recoveries failed (terminal state)
};

/// Word of a state in logs.
const char* to_string(RecoveryState state);

/// Decision of the recovery manager, with the values that logs and pictures show.
struct RecoveryDecision {
    RecoveryState state = RecoveryState::Driving;
    MotionCommand command;
    Eigen::Vector2d waypoint_m = Eigen::Vector2d::Zero();  ///< map frame
    std::vector<Eigen::Vector2d> path_m;                   ///< the plan, map frame; empty: none
    double free_m = 0.0;                                   ///< see Decision
    bool last_goal = false;                                ///< all way points but the goal have been reached
    std::string why;
};

/// Leads a local navigator to a goal, past dead ends: plans way points on the map of everything seen, and
/// frees the robot with recoveries when it is stuck. Its state machine:
///
///     Driving -> (stuck, held by the guard, or no progress) -> one recovery -> Driving; they take turns:
///     TurningToWay, BackingOff then TurningToWay, LookingLeft then LookingRight then TurningToWay;
///     a step that the guard does not allow is left out
///     Driving -> (goal reached) -> Arrived       Driving -> (recoveries_max in one place) -> Blocked
///
/// All times are those of the caller.
class RecoveryManager {
  public:
    /// `goals_m`: way points in the map frame, the last one is the goal. Throws std::invalid_argument: none.
    RecoveryManager(const RobotModel& robot, const RecoveryParams& params,
                    std::unique_ptr<Navigator> navigator, std::vector<Eigen::Vector2d> goals_m);

    /// A robot that follows a way point fixed in its own frame, without end. Its recoveries are BackingOff
    /// alone, and BackingOff, LookingLeft, LookingRight.
    RecoveryManager(const RobotModel& robot, const RecoveryParams& params,
                    std::unique_ptr<Navigator> navigator, const Eigen::Vector2d& waypoint_robot_m);

    /// Called every 100 or 200 ms. `map` holds everything seen so far, map frame.
    RecoveryDecision decide(const Situation& situation, const mrpt::maps::COccupancyGridMap2D& map);

  private:
    struct Progress {
        double time_s = 0.0;
        double to_go_m = 0.0;
    };

    void note_trail(const Pose2& T_map_robot);
    bool is_at_goal(const Situation& situation);
    void aim(const Situation& situation, const mrpt::maps::COccupancyGridMap2D& map);
    void drive(const Situation& situation);
    void note_progress(const Situation& situation);
    bool is_held(const Situation& situation);
    void begin_recovery(const Situation& situation);
    std::vector<RecoveryState> sequence_to_goal() const;
    std::vector<RecoveryState> sequence_of_follower() const;
    void avoid_this_place(const Situation& situation);
    void enter(RecoveryState state, const Situation& situation);
    void recovery(const Situation& situation);
    void turn_to(double yaw_rad, const Situation& situation);
    void back_off(const Situation& situation, double far_enough_m);
    void creep_on(const Situation& situation);
    void next_of_sequence(const Situation& situation);

    RobotModel robot_;
    RecoveryParams params_;
    PlanParams planner_;
    std::unique_ptr<Navigator> navigator_;
    std::vector<Eigen::Vector2d> goals_m_;
    std::optional<Eigen::Vector2d> waypoint_robot_m_;
    std::size_t goal_ = 0;  ///< index of the goal that is driven to
    RecoveryDecision decision_;
    std::optional<Plan> plan_;
    Progress best_;  ///< nearest to the goal so far, and when
    std::optional<double> stuck_since_s_;
    double moved_s_ = 0.0;  ///< when it last moved, or did not want to
    Pose2 moved_to_;
    std::deque<Pose2> trail_;              ///< poses passed, map frame
    bool planning_ = false;                ///< ReplanPolicy::WhenStuck: until the next goal
    int recoveries_ = 0;                   ///< since the last progress
    std::vector<RecoveryState> sequence_;  ///< of the running recovery, the next step last
    double entered_s_ = 0.0;               ///< when the state began
    Pose2 entered_at_;                     ///< and where
};

}  // namespace flownav::nav
