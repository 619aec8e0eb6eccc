#include "flownav/nav/recovery_manager.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "flownav/mapping/grid_area.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2i;
using mrpt::maps::COccupancyGridMap2D;

constexpr double progress_m = 0.15;     // nearer by this much is progress
constexpr double turned_rad = 0.06;     // near enough to a wanted heading
constexpr double recovery_max_s = 8.0;  // a step that takes longer is given up
constexpr double place_ahead_m = 0.3;   // along the plan: where a stuck robot wanted to go
constexpr double freed_m = 0.5;         // a follower that has come so far is stuck no more
constexpr double moved_m = 0.02;        // less is standing
constexpr double moved_rad = 0.04;      // likewise
constexpr double trail_step_m = 0.1;
constexpr double trail_step_rad = 0.1;
constexpr std::size_t trail_poses = 50;
constexpr double beside_trail_m = 0.12;
constexpr double way_of_turning_m = 0.6;  // part of the plan that tells where to turn to

Vector2d position(const Pose2& pose) {
    return {pose.x_m, pose.y_m};
}

double heading_to(const Vector2d& from_m, const Vector2d& to_m) {
    return std::atan2(to_m.y() - from_m.y(), to_m.x() - from_m.x());
}

/// Whether the robot has stood there, or nearly so, on one of the poses of its trail.
bool is_driven(const std::deque<Pose2>& trail, const RobotModel& robot, const Vector2d& at_map_m) {
    return std::any_of(trail.begin(), trail.end(), [&](const Pose2& T_map_robot) {
        return signed_distance_m(robot.footprint_m, transform(inverse(T_map_robot), at_map_m)) <
               beside_trail_m;
    });
}

/// How far the robot can back over ground that is known to be free, or that it came over, up to `wanted_m`.
/// It stands on the ground below it, whatever the map says.
double known_behind_m(const Situation& situation, const RobotModel& robot, const std::deque<Pose2>& trail,
                      const mapping::OccupancyLimits& limits, double wanted_m) {
    const auto& map = *situation.local_map;
    const GridArea area = mapping::area_of(map);
    const double step_m = area.cell_m;
    double rear_m = 0.0;
    double half_m = 0.0;
    for (const Vector2d& corner : robot.footprint_m) {
        rear_m = std::min(rear_m, corner.x());
        half_m = std::max(half_m, std::abs(corner.y()));
    }
    for (double back_m = 0.0; back_m < wanted_m; back_m += step_m) {
        const double x = rear_m - back_m - step_m;
        for (double y = -half_m - step_m; y <= half_m + step_m; y += step_m) {
            const double p_free = mapping::p_free_at(map, area, {x, y});
            if (p_free >= limits.backing_free_above) continue;
            const bool driven = is_driven(trail, robot, transform(situation.T_map_robot, {x, y}));
            if (p_free < limits.plan_obstacle_below || !driven) return back_m;
        }
    }
    return wanted_m;
}

/// The map without the obstacles that the local map, which forgets, does not show: they may be gone.
COccupancyGridMap2D without_old_obstacles(COccupancyGridMap2D map, const Situation& situation,
                                          double p_occupied) {
    const auto& local = *situation.local_map;
    const Vector2d here = position(situation.T_map_robot);
    const Pose2 T_robot_map = inverse(situation.T_map_robot);
    const Vector2d half_m = Vector2d::Constant(local.getXMax());
    const GridArea area = mapping::area_of(map);
    const GridArea local_area = mapping::area_of(local);
    const Vector2i size(area.columns, area.rows);
    const Vector2i low = area.cell_of(here - half_m).cwiseMax(0).cwiseMin(size);
    const Vector2i high = area.cell_of(here + half_m).cwiseMax(0).cwiseMin(size);
    for (int y = low.y(); y < high.y(); ++y) {
        for (int x = low.x(); x < high.x(); ++x) {
            if (map.getCell(x, y) >= p_occupied) continue;
            const Vector2d p = transform(T_robot_map, area.middle_of({x, y}));
            if (p.cwiseAbs().maxCoeff() >= half_m.x()) continue;
            const auto seen = static_cast<float>(mapping::p_free_at(local, local_area, p));
            map.setCell(x, y, std::max(map.getCell(x, y), seen));
        }
    }
    return map;
}

}  // namespace

const char* to_string(RecoveryState state) {
    constexpr std::array<const char*, 8> words = {"driving",       "turning_to_way", "looking_left",
                                                  "looking_right", "backing_off",    "creeping_on",
                                                  "arrived",       "blocked"};
    return words[static_cast<std::size_t>(state)];
}

RecoveryManager::RecoveryManager(const RobotModel& robot, const RecoveryParams& params,
                                 std::unique_ptr<Navigator> navigator, std::vector<Vector2d> goals_m)
    : robot_(robot), params_(params), navigator_(std::move(navigator)), goals_m_(std::move(goals_m)) {
    planner_.limits = params_.limits;
    if (goals_m_.empty()) throw std::invalid_argument("the pilot needs a goal");
}

RecoveryManager::RecoveryManager(const RobotModel& robot, const RecoveryParams& params,
                                 std::unique_ptr<Navigator> navigator, const Vector2d& waypoint_robot_m)
    : robot_(robot), params_(params), navigator_(std::move(navigator)), waypoint_robot_m_(waypoint_robot_m) {}

RecoveryDecision RecoveryManager::decide(const Situation& situation,
                                         const mrpt::maps::COccupancyGridMap2D& map) {
    decision_.command = {};
    decision_.why.clear();
    if (decision_.state == RecoveryState::Arrived || decision_.state == RecoveryState::Blocked)
        return decision_;
    if (is_at_goal(situation)) {
        enter(RecoveryState::Arrived, situation);
        return decision_;
    }
    note_trail(situation.T_map_robot);
    aim(situation, map);
    if (decision_.state == RecoveryState::Driving) {
        drive(situation);
    } else {
        recovery(situation);
    }
    return decision_;
}

void RecoveryManager::note_trail(const Pose2& T_map_robot) {
    if (!trail_.empty()) {
        const Pose2 step = compose(inverse(trail_.back()), T_map_robot);
        if (position(step).norm() < trail_step_m && std::abs(step.yaw_rad) < trail_step_rad) return;
    }
    trail_.push_back(T_map_robot);
    if (trail_.size() > trail_poses) trail_.pop_front();
}

bool RecoveryManager::is_at_goal(const Situation& situation) {
    if (waypoint_robot_m_) return false;
    while (goal_ < goals_m_.size() &&
           (goals_m_[goal_] - position(situation.T_map_robot)).norm() <= params_.goal_radius_m) {
        ++goal_;
        planner_.avoid_m.clear();
        planning_ = false;
        best_ = {};
    }
    decision_.last_goal = goal_ + 1 >= goals_m_.size();
    return goal_ == goals_m_.size();
}

/// Sets the way point.
void RecoveryManager::aim(const Situation& situation, const mrpt::maps::COccupancyGridMap2D& map) {
    plan_.reset();
    decision_.path_m.clear();
    if (waypoint_robot_m_) {
        decision_.waypoint_m = transform(situation.T_map_robot, *waypoint_robot_m_);
        return;
    }
    decision_.waypoint_m = goals_m_[goal_];
    const bool plans = params_.replan == ReplanPolicy::Always || planning_;
    if (!plans || params_.replan == ReplanPolicy::Never) return;
    const Vector2d here = position(situation.T_map_robot);
    plan_ = plan(map, here, goals_m_[goal_], robot_, planner_);
    if (!plan_->reaches_goal) {
        const auto hopeful =
            without_old_obstacles(map, situation, params_.limits.plan_obstacle_below);
        Plan other = plan(hopeful, here, goals_m_[goal_], robot_, planner_);
        if (other.reaches_goal) plan_ = std::move(other);
    }
    decision_.path_m = plan_->path_m;
    decision_.waypoint_m = plan_->way_point_m;
}

void RecoveryManager::drive(const Situation& situation) {
    Situation here = situation;
    here.stop_at_waypoint =
        !waypoint_robot_m_ && decision_.last_goal && (decision_.waypoint_m - goals_m_.back()).norm() < 0.1;
    const Decision wanted = navigator_->decide(here, decision_.waypoint_m);
    decision_.command = wanted.command;
    decision_.free_m = wanted.free_m;
    decision_.why = wanted.why;
    note_progress(situation);
    if (!wanted.stuck) stuck_since_s_.reset();
    if (wanted.stuck && !stuck_since_s_) stuck_since_s_ = situation.time_s;
    const bool stuck = stuck_since_s_ && situation.time_s - *stuck_since_s_ >= params_.stuck_s;
    const bool held = is_held(situation);
    const bool waits = situation.time_s - best_.time_s >= params_.no_progress_s;
    if (!situation.obstacles_known) {  // standing still for the guard's reasons is not being stuck
        best_.time_s = situation.time_s;
        stuck_since_s_.reset();
    } else if (stuck || held || waits) {
        begin_recovery(situation);
        decision_.why = stuck ? "no way is open" : held ? "the guard holds it" : "no progress";
    }
}

/// The robot has wanted to move for a while, and something keeps it where it is. `decision_` holds the
/// command.
bool RecoveryManager::is_held(const Situation& situation) {
    const Pose2 way = compose(inverse(moved_to_), situation.T_map_robot);
    const MotionCommand& wanted = decision_.command;
    const bool moves = position(way).norm() > moved_m || std::abs(way.yaw_rad) > moved_rad;
    const bool rests = wanted.v_mps == 0.0 && wanted.omega_radps == 0.0;
    if (moves || rests || !situation.obstacles_known) {
        moved_s_ = situation.time_s;
        moved_to_ = situation.T_map_robot;
    }
    return situation.time_s - moved_s_ >= params_.held_s;
}

void RecoveryManager::note_progress(const Situation& situation) {
    if (waypoint_robot_m_) {  // the way point comes no nearer: moving on is progress
        best_.time_s = situation.time_s;
        if (position(compose(inverse(entered_at_), situation.T_map_robot)).norm() > freed_m) recoveries_ = 0;
        return;
    }
    // A plan that is found to be closed makes the rest longer: measured against the new one from then on.
    const double to_go_m =
        plan_ ? length_m(plan_->path_m) : (goals_m_[goal_] - position(situation.T_map_robot)).norm();
    const bool first = best_.to_go_m == 0.0;
    if (first || to_go_m < best_.to_go_m - progress_m || to_go_m > best_.to_go_m + 1.0) {
        if (!first && to_go_m < best_.to_go_m) recoveries_ = 0;
        best_ = {situation.time_s, to_go_m};
    }
}

void RecoveryManager::begin_recovery(const Situation& situation) {
    stuck_since_s_.reset();
    planning_ = true;
    if (++recoveries_ > params_.recoveries_max) {
        enter(RecoveryState::Blocked, situation);
        return;
    }
    if (recoveries_ > 1) avoid_this_place(situation);
    sequence_ = waypoint_robot_m_ ? sequence_of_follower() : sequence_to_goal();
    next_of_sequence(situation);
}

/// The next step last.
std::vector<RecoveryState> RecoveryManager::sequence_to_goal() const {
    switch (recoveries_ % 3) {
        case 1:
            return {RecoveryState::TurningToWay};
        case 2:
            return {RecoveryState::TurningToWay, RecoveryState::BackingOff};
        default:
            return {RecoveryState::TurningToWay, RecoveryState::LookingRight, RecoveryState::LookingLeft};
    }
}

/// What pulls it to its way point has brought it here: it goes on turned away from that. The next step last.
std::vector<RecoveryState> RecoveryManager::sequence_of_follower() const {
    const RecoveryState away =
        waypoint_robot_m_->y() > 0.0 ? RecoveryState::LookingRight : RecoveryState::LookingLeft;
    return {away, recoveries_ % 2 == 1 ? RecoveryState::BackingOff : RecoveryState::CreepingOn};
}

/// Where it wanted to go, and could not twice.
void RecoveryManager::avoid_this_place(const Situation& situation) {
    for (const Vector2d& at_m : decision_.path_m) {
        if ((at_m - position(situation.T_map_robot)).norm() < place_ahead_m) continue;
        planner_.avoid_m.push_back(at_m);
        return;
    }
}

void RecoveryManager::next_of_sequence(const Situation& situation) {
    if (sequence_.empty()) {
        best_.time_s = situation.time_s;  // a new chance
        enter(RecoveryState::Driving, situation);
        return;
    }
    enter(sequence_.back(), situation);
    sequence_.pop_back();
}

void RecoveryManager::enter(RecoveryState state, const Situation& situation) {
    decision_.state = state;
    decision_.command = {};
    entered_s_ = moved_s_ = situation.time_s;
    entered_at_ = moved_to_ = situation.T_map_robot;
}

void RecoveryManager::recovery(const Situation& situation) {
    if (situation.time_s - entered_s_ > recovery_max_s) {
        next_of_sequence(situation);
        return;
    }
    const double yaw_rad = entered_at_.yaw_rad;
    switch (decision_.state) {
        case RecoveryState::TurningToWay: {
            const Vector2d here_m = position(situation.T_map_robot);
            Vector2d ahead_m = decision_.waypoint_m;
            for (const Vector2d& at_m : decision_.path_m) {
                ahead_m = at_m;
                if ((at_m - here_m).norm() > way_of_turning_m) break;
            }
            turn_to(heading_to(here_m, ahead_m), situation);
            break;
        }
        case RecoveryState::LookingLeft:
            turn_to(yaw_rad + (waypoint_robot_m_ ? params_.away_rad : params_.look_rad), situation);
            break;
        case RecoveryState::LookingRight:
            turn_to(yaw_rad - (waypoint_robot_m_ ? params_.away_rad : 2.0 * params_.look_rad), situation);
            break;
        case RecoveryState::CreepingOn:
            creep_on(situation);
            break;
        default:
            back_off(situation, params_.back_off_m);
    }
    if (is_held(situation)) next_of_sequence(situation);
}

void RecoveryManager::turn_to(double yaw_rad, const Situation& situation) {
    const double left_rad = wrap_angle(yaw_rad - situation.T_map_robot.yaw_rad);
    if (std::abs(left_rad) < turned_rad) {
        next_of_sequence(situation);
        return;
    }
    const double fastest = std::min(params_.turn_radps, robot_.omega_max_radps);
    decision_.command.omega_radps = std::clamp(2.0 * left_rad, -fastest, fastest);
}

void RecoveryManager::back_off(const Situation& situation, double far_enough_m) {
    const double done_m = (position(situation.T_map_robot) - position(entered_at_)).norm();
    const double known_m = known_behind_m(situation, robot_, trail_, params_.limits, far_enough_m);
    decision_.free_m = known_m;
    if (done_m >= far_enough_m || known_m < 0.05) {
        next_of_sequence(situation);
        return;
    }
    decision_.command.v_mps = -robot_.v_back_mps;
}

void RecoveryManager::creep_on(const Situation& situation) {
    if ((position(situation.T_map_robot) - position(entered_at_)).norm() >= params_.creep_on_m) {
        next_of_sequence(situation);
        return;
    }
    decision_.command.v_mps = std::min(params_.creep_mps, robot_.v_max_mps);
}

}  // namespace flownav::nav
