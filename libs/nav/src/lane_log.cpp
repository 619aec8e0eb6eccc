#include "lane_log.h"

#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/nav/holonomic/CHolonomicVFF.h>
#include <mrpt/nav/reactive/CLogFileRecord.h>
#include <mrpt/serialization/CArchive.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::nav::CLogFileRecord;

std::filesystem::path free_name(const std::filesystem::path& folder) {
    for (int number = 0;; ++number) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "log_%03d.reactivenavlog", number);
        if (!std::filesystem::exists(folder / name.data())) return folder / name.data();
    }
}

void add_obstacles(const LaneTables& tables, const mrpt::maps::COccupancyGridMap2D& map,
                   const CellLimits& limits, CLogFileRecord& record) {
    const std::vector<CellKind> kinds = kinds_of(map, limits);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] != CellKind::Occupied) continue;
        const auto columns = static_cast<std::size_t>(tables.grid.columns);
        const Vector2d p =
            tables.grid.middle_of(static_cast<int>(i % columns), static_cast<int>(i / columns));
        record.WS_Obstacles.insertPoint(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
    }
    record.WS_Obstacles_original = record.WS_Obstacles;
}

/// The lanes as the paths of one "PTG"; their free ways are its obstacles.
CLogFileRecord::TInfoPerPTG lanes_of(const LaneTables& tables, const LaneDecision& decision) {
    CLogFileRecord::TInfoPerPTG info;
    info.PTG_desc = "flownav lanes, from hard right to hard left";
    info.timeForTPObsTransformation = info.timeForHolonomicMethod = 0.0;
    info.desiredDirection = info.desiredSpeed = info.evaluation = 0.0;
    info.HLFR = std::make_shared<mrpt::nav::CLogFileRecord_VFF>();
    const auto lanes = static_cast<Eigen::Index>(decision.lanes.size());
    info.TP_Obstacles.resize(lanes);
    for (Eigen::Index i = 0; i < lanes; ++i) {
        info.TP_Obstacles[i] =
            static_cast<float>(decision.lanes[static_cast<std::size_t>(i)].free_m / tables.layout.length_m);
    }
    if (decision.lane >= 0) {
        const LaneView& lane = decision.lanes[static_cast<std::size_t>(decision.lane)];
        info.desiredDirection = -M_PI + 2.0 * M_PI * (decision.lane + 0.5) / static_cast<double>(lanes);
        info.desiredSpeed = decision.command.v_mps / tables.robot.v_max_mps;
        info.evaluation = lane.score;
        info.evalFactors = {{"near", lane.near}, {"free_m", lane.free_m}, {"gap_m", lane.gap_m},
                            {"seen", lane.seen}, {"sure", lane.sure},     {"unseen_m", lane.unseen_m}};
    }
    return info;
}

}  // namespace

LaneLog::LaneLog(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::filesystem::path name = free_name(folder);
    if (error || !file_.open(name.string(), 1))
        throw std::runtime_error("cannot write the navlog " + name.string() + ": choose another folder");
}

void LaneLog::write(const LaneTables& tables, const Situation& situation, const Vector2d& waypoint_robot_m,
                    const CellLimits& limits, const LaneDecision& decision) {
    CLogFileRecord record;
    record.nPTGs = 1;
    record.infoPerPTG.push_back(lanes_of(tables, decision));
    record.nSelectedPTG = decision.lane >= 0 ? 0 : -1;
    const auto now = mrpt::Clock::fromDouble(situation.time_s);
    record.timestamps = {{"tim_start_iteration", now}, {"curPoseAndVel", now}, {"tim_send_cmd_vel", now}};
    record.values = {{"free_m", decision.way.occupied}, {"unseen_m", decision.way.unseen}};
    record.additional_debug_msgs = {{"why", decision.why}};
    const Pose2& at = situation.T_map_robot;
    record.robotPoseLocalization = record.robotPoseOdometry = {at.x_m, at.y_m, at.yaw_rad};
    record.WS_targets_relative.emplace_back(waypoint_robot_m.x(), waypoint_robot_m.y(), 0.0);
    auto command = std::make_shared<mrpt::kinematics::CVehicleVelCmd_DiffDriven>();
    command->lin_vel = decision.command.v_mps;
    command->ang_vel = decision.command.omega_radps;
    record.cmd_vel = record.cmd_vel_original = command;
    record.cur_vel_local = {situation.motion.v_mps, 0.0, situation.motion.omega_radps};
    record.cur_vel = record.cur_vel_local.rotated(at.yaw_rad);
    for (const Vector2d& corner : tables.robot.footprint_m) {
        record.robotShape_x.push_back(static_cast<float>(corner.x()));
        record.robotShape_y.push_back(static_cast<float>(corner.y()));
    }
    add_obstacles(tables, *situation.local_map, limits, record);
    mrpt::serialization::archiveFrom(file_) << record;
}

}  // namespace flownav::nav
