#include "flownav/nav/lane_navigation_system.h"

#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>

#include <algorithm>
#include <utility>

#include "lane_log.h"
#include "lane_view.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;

constexpr double reached = 0.9;  // nearness above which a lane counts as leading to a way point

}  // namespace

CLaneNavigationSystem::CLaneNavigationSystem(GridRobot& robot, LaneTables tables, const LaneParams& params,
                                             const std::string& navlog_dir)
    : CWaypointsNavigator(robot), grid_robot_(robot), tables_(std::move(tables)), params_(params) {
    if (!navlog_dir.empty()) log_ = std::make_unique<LaneLog>(navlog_dir);
}

CLaneNavigationSystem::~CLaneNavigationSystem() {
    m_timlog_delays.clear(true);  // otherwise it writes its statistics to the console
}

void CLaneNavigationSystem::performNavigationStep() {
    const Situation& situation = grid_robot_.situation();
    decision_ = {};
    if (!situation.obstacles_known || !situation.local_map) {
        decision_.why = "obstacles are not known";
        stop(true);
        return;
    }
    const auto& target = m_navigationParams->target.target_coords;
    const Vector2d waypoint_m = transform(inverse(situation.T_map_robot), {target.x, target.y});
    LaneParams params = params_;
    if (!situation.stop_at_waypoint) params.arrival_mps = tables_.robot.v_max_mps;
    decision_ = choose_lane(tables_, *situation.local_map, waypoint_m, situation.motion, params);
    if (log_) log_->write(tables_, situation, waypoint_m, params_.limits, decision_);
    if (decision_.stuck) {
        stop(true);
        return;
    }
    mrpt::kinematics::CVehicleVelCmd_DiffDriven command;
    command.lin_vel = decision_.command.v_mps;
    command.ang_vel = decision_.command.omega_radps;
    if (!changeSpeeds(command)) doEmergencyStop("the robot takes no commands");
}

bool CLaneNavigationSystem::impl_waypoint_is_reachable(const mrpt::math::TPoint2D& waypoint_robot_m) const {
    const Vector2d waypoint_m(waypoint_robot_m.x, waypoint_robot_m.y);
    LaneParams params = params_;
    params.horizon_m = waypoint_m.norm();
    return std::any_of(decision_.lanes.begin(), decision_.lanes.end(), [&](const LaneView& lane) {
        return lane.open && nearness(lane, waypoint_m, params) > reached;
    });
}

}  // namespace flownav::nav
