#include "lane_log.h"

#include <mrpt/config/CConfigFileMemory.h>
#include <mrpt/kinematics/CVehicleVelCmd_DiffDriven.h>
#include <mrpt/nav/holonomic/CHolonomicVFF.h>
#include <mrpt/nav/reactive/CLogFileRecord.h>
#include <mrpt/nav/tpspace/CPTG_DiffDrive_C.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "flownav/math/units.h"

namespace flownav::nav {
namespace {

using Eigen::Vector2d;
using mrpt::nav::CLogFileRecord;

constexpr int paths = 121;  // number of circular paths that the viewer shows

std::filesystem::path free_name(const std::filesystem::path& folder) {
    for (int number = 0;; ++number) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "log_%03d.reactivenavlog", number);
        if (!std::filesystem::exists(folder / name.data())) return folder / name.data();
    }
}

void add_obstacles(const LaneTables& tables, const mrpt::maps::COccupancyGridMap2D& map,
                   const mapping::OccupancyLimits& limits, CLogFileRecord& record) {
    const std::vector<CellKind> kinds = kinds_of(map, limits);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i] != CellKind::Occupied) continue;
        const Vector2d p = tables.grid.middle_of(tables.grid.cell_at(i));
        record.WS_Obstacles.insertPoint(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
    }
    record.WS_Obstacles_original = record.WS_Obstacles;
}

/// Returns MRPT's circular paths: lanes evenly spaced in curvature.
mrpt::nav::CParameterizedTrajectoryGenerator::Ptr circular_paths(const LaneTables& tables) {
    const double v_max_mps = tables.robot.v_max_mps;
    mrpt::config::CConfigFileMemory config;
    config.write("ptg", "resolution", tables.layout.resolution_m);
    config.write("ptg", "refDistance", tables.layout.length_m);
    config.write("ptg", "num_paths", paths);
    config.write("ptg", "v_max_mps", v_max_mps);
    config.write("ptg", "w_max_dps", deg(v_max_mps / tables.layout.radius_min_m));
    config.write("ptg", "K", 1.0);
    auto ptg = std::make_shared<mrpt::nav::CPTG_DiffDrive_C>();
    ptg->loadFromConfigFile(config, "ptg");
    mrpt::math::CPolygon shape;
    for (const Vector2d& corner : tables.robot.footprint_m) shape.AddVertex(corner.x(), corner.y());
    ptg->setRobotShape(shape);
    return ptg;
}

/// Returns the index of the lane nearest to a circular path.
std::size_t lane_of(const LaneTables& tables, Eigen::Index path) {
    const double share = 2.0 * (static_cast<double>(path) + 0.5) / paths - 1.0;
    const double curvature_1pm = share / tables.layout.radius_min_m;
    const auto next = std::lower_bound(tables.lanes.begin(), tables.lanes.end(), curvature_1pm,
                                       [](const Lane& lane, double c) { return lane.curvature_1pm < c; });
    if (next == tables.lanes.end()) return tables.lanes.size() - 1;
    const auto index = static_cast<std::size_t>(next - tables.lanes.begin());
    const bool before = index > 0 && curvature_1pm - tables.lanes[index - 1].curvature_1pm <
                                         next->curvature_1pm - curvature_1pm;
    return before ? index - 1 : index;
}

/// Converts the free distances of the lanes to obstacles of the circular paths.
CLogFileRecord::TInfoPerPTG lanes_of(const LaneTables& tables, const LaneDecision& decision) {
    CLogFileRecord::TInfoPerPTG info;
    info.PTG_desc = "flownav lanes, from hard right to hard left";
    info.timeForTPObsTransformation = info.timeForHolonomicMethod = 0.0;
    info.desiredDirection = info.desiredSpeed = info.evaluation = 0.0;
    info.HLFR = std::make_shared<mrpt::nav::CLogFileRecord_VFF>();
    info.TP_Obstacles.resize(paths);
    for (Eigen::Index i = 0; i < paths; ++i) {
        info.TP_Obstacles[i] =
            static_cast<float>(decision.lanes[lane_of(tables, i)].free_m / tables.layout.length_m);
    }
    if (decision.lane >= 0) {
        const LaneView& lane = decision.lanes[static_cast<std::size_t>(decision.lane)];
        const double curvature_1pm = tables.lanes[static_cast<std::size_t>(decision.lane)].curvature_1pm;
        info.desiredDirection = M_PI * std::clamp(curvature_1pm * tables.layout.radius_min_m, -1.0, 1.0);
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
                    const mapping::OccupancyLimits& limits, const LaneDecision& decision) {
    CLogFileRecord record;
    record.nPTGs = 1;
    record.infoPerPTG.push_back(lanes_of(tables, decision));
    if (first_) record.infoPerPTG[0].ptg = circular_paths(tables);
    first_ = false;
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
