#include "flownav/nav/grid_robot.h"

#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/maps/CSimplePointsMap.h>

#include <algorithm>
#include <cmath>

namespace flownav::nav {
namespace {

using mrpt::kinematics::CVehicleVelCmd;
using mrpt::kinematics::CVehicleVelCmd_DiffDriven;

CVehicleVelCmd::Ptr stop_command() {
    return std::make_shared<CVehicleVelCmd_DiffDriven>();  // zero velocity
}

}  // namespace

GridRobot::GridRobot(const RobotModel& robot, const mapping::OccupancyLimits& limits, double margin_m,
                     WatchdogSink* watchdog)
    : robot_(robot),
      limits_(limits),
      margin_m_(margin_m),
      field_(robot.footprint_m, margin_m + 0.01),
      watchdog_(watchdog) {}

void GridRobot::see(const Situation& situation) {
    situation_ = situation;
    emergency_stop_ = false;
}

bool GridRobot::getCurrentPoseAndSpeeds(mrpt::math::TPose2D& pose, mrpt::math::TTwist2D& velocity_map,
                                        mrpt::system::TTimeStamp& timestamp, mrpt::math::TPose2D& odometry,
                                        std::string& frame_id) {
    const Pose2& at = situation_.T_map_robot;
    pose = {at.x_m, at.y_m, at.yaw_rad};
    odometry = pose;
    velocity_map = {situation_.motion.v_mps * std::cos(at.yaw_rad),
                    situation_.motion.v_mps * std::sin(at.yaw_rad), situation_.motion.omega_radps};
    timestamp = mrpt::Clock::fromDouble(situation_.time_s);
    frame_id = "map";
    return true;
}

bool GridRobot::changeSpeeds(const CVehicleVelCmd& command) {
    const auto* const wanted = dynamic_cast<const CVehicleVelCmd_DiffDriven*>(&command);
    if (!wanted) return false;
    command_ = {wanted->lin_vel, wanted->ang_vel};
    if (watchdog_) watchdog_->alive();
    return true;
}

bool GridRobot::changeSpeedsNOP() {
    if (watchdog_) watchdog_->alive();
    return true;
}

bool GridRobot::stop(bool is_emergency) {
    command_ = {};
    emergency_stop_ = emergency_stop_ || is_emergency;
    if (watchdog_) watchdog_->alive();
    return true;
}

CVehicleVelCmd::Ptr GridRobot::getEmergencyStopCmd() {
    return stop_command();
}

CVehicleVelCmd::Ptr GridRobot::getStopCmd() {
    return stop_command();
}

CVehicleVelCmd::Ptr GridRobot::getAlignCmd(double heading_rad) {
    auto command = std::make_shared<CVehicleVelCmd_DiffDriven>();
    command->ang_vel = std::copysign(std::min(robot_.omega_max_radps, std::abs(heading_rad)), heading_rad);
    return command;
}

bool GridRobot::startWatchdog(float period_ms) {
    if (watchdog_) watchdog_->start_watchdog(static_cast<double>(period_ms) / 1000.0);
    return true;
}

bool GridRobot::stopWatchdog() {
    if (watchdog_) watchdog_->stop_watchdog();
    return true;
}

bool GridRobot::senseObstacles(mrpt::maps::CSimplePointsMap& obstacles, mrpt::system::TTimeStamp& timestamp) {
    obstacles.clear();
    timestamp = mrpt::Clock::fromDouble(situation_.time_s);
    if (!situation_.obstacles_known || !situation_.local_map) return false;
    const auto& map = *situation_.local_map;
    const std::vector<CellKind> kinds = kinds_of(map, limits_);
    const auto columns = static_cast<int>(map.getSizeX());
    const auto z = static_cast<float>(robot_.height_m / 2);  // within the height range of MRPT's navigators
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] != CellKind::Occupied) continue;
        const float x = map.idx2x(static_cast<int>(i) % columns);
        const float y = map.idx2y(static_cast<int>(i) / columns);
        if (field_.distance_m({x, y}) < margin_m_) continue;
        obstacles.insertPoint(x, y, z);
    }
    return true;
}

}  // namespace flownav::nav
