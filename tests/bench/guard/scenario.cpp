#include "scenario.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <memory>

#include "flownav/math/units.h"

namespace flownav {
namespace {

constexpr double lane_m = 8.5;
constexpr double half_width_m = 1.6;
constexpr double goal_m = 4.5;
constexpr double reaction_s = 0.3;
constexpr double tick_s = 0.02;
constexpr double mover_speed_mps = 3.0;
constexpr double mover_width_m = 2.4;
constexpr double mover_depth_m = 0.4;
constexpr double mover_out_m = 3.0;
constexpr double standing = 1e-3;

sim::Solid box(const std::string& name, const Eigen::Vector3d& size_m, const Eigen::Vector2d& at_m,
               std::uint64_t texture) {
    sim::Solid solid;
    solid.name = name;
    solid.shape = sim::Box{size_m};
    solid.T_world_solid.translation() << at_m, size_m.z() / 2;
    solid.look = {sim::Surface::Patterned, 110.0 + 60.0 * chance(texture, 7), texture};
    return solid;
}

/// A lane between two walls, with boxes and poles along them.
sim::World make_world(std::uint64_t seed) {
    sim::World world;
    world.name = "lane";
    world.floor = {sim::Surface::Carpet, 128.0, seed};
    for (const double side : {1.0, -1.0}) {
        world.solids.push_back(box(side > 0 ? "left wall" : "right wall", {lane_m + 4.0, 0.1, 1.5},
                                   {lane_m / 2 - 1.0, side * (half_width_m + 0.05)}, seed * 10 + (side > 0)));
    }
    world.solids.push_back(box("back wall", {0.1, 2 * half_width_m, 1.5}, {-1.5, 0.0}, seed * 10 + 9));
    world.solids.push_back(box("end wall", {0.1, 2 * half_width_m, 1.5}, {lane_m, 0.0}, seed * 10 + 2));
    for (int i = 0; i < 4; ++i) {
        const auto n = static_cast<std::uint64_t>(10 * i);
        const double size_m = 0.2 + 0.3 * chance(seed, n + 1);
        const double side = chance(seed, n + 2) < 0.5 ? 1.0 : -1.0;
        world.solids.push_back(
            box("box " + std::to_string(i), {size_m, size_m, 0.3 + 0.7 * chance(seed, n + 3)},
                {1.8 + 1.5 * i + 0.5 * chance(seed, n + 4), side * (half_width_m - size_m / 2 - 0.1)},
                seed * 10 + 3 + static_cast<std::uint64_t>(i)));
    }
    world.start = {};
    world.goal = Eigen::Vector2d(goal_m, 0.0);
    return world;
}

/// An object that waits behind the wall, slides across the lane, blocks it, stays, and goes back.
sim::Solid mover(const FaultPlan& plan, const Pose2& T_world_robot, double ahead_m) {
    const double side = chance(plan.seed, 21) < 0.5 ? 1.0 : -1.0;
    const double x_m = T_world_robot.x_m + ahead_m + mover_depth_m / 2;
    const Eigen::Vector2d in(x_m, 0.0);
    const Eigen::Vector2d out(x_m, side * mover_out_m);
    sim::Solid solid = box("mover", {mover_depth_m, mover_width_m, 1.0}, out, plan.seed + 99);
    const auto place = [&](double time_s, const Eigen::Vector2d& at_m) {
        sim::TimedPose pose;
        pose.time_s = time_s;
        pose.T_world_solid.translation() << at_m, 0.5;
        solid.script.push_back(pose);
    };
    // The edge of the object leaves the wall at from_s.
    const double walk_s = mover_out_m / mover_speed_mps;
    const double hidden_s = (mover_out_m - mover_width_m / 2 - half_width_m) / mover_speed_mps;
    place(std::max(0.0, plan.from_s - hidden_s), out);
    place(plan.from_s - hidden_s + walk_s, in);
    place(plan.until_s, in);
    place(plan.until_s + walk_s, out);
    return solid;
}

double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

bool is_of_the_sensor(nav::GuardReason reason) {
    return reason != nav::GuardReason::ObstacleAhead && reason != nav::GuardReason::UnseenAhead &&
           reason != nav::GuardReason::None;
}

void measure(const drive::DriveResult& drive, const FaultPlan& plan, RunRow& row) {
    row.outcome = to_string(drive.outcome);
    row.contact_mps = drive.contact_speed_mps;
    row.drives_on = drive.outcome == drive::Outcome::Reached;
    row.min_clearance_m = 1e9;
    double path_m = 0.0;
    const drive::DriveSample* before = nullptr;
    for (const drive::DriveSample& sample : drive.samples) {
        if (sample.time_s < plan.from_s - tick_s / 2) continue;
        row.min_clearance_m = std::min(row.min_clearance_m, sample.clearance_m);
        if (before != nullptr) {
            path_m += std::hypot(sample.T_world_robot.x_m - before->T_world_robot.x_m,
                                 sample.T_world_robot.y_m - before->T_world_robot.y_m);
        }
        before = &sample;
        const bool stands =
            std::abs(sample.motion.v_mps) < standing && std::abs(sample.motion.omega_radps) < standing;
        if (row.stop_s < 0.0 && stands && sample.time_s < plan.until_s) {
            row.stop_s = sample.time_s - plan.from_s;
            row.way_m = path_m;
        }
        if (row.after_fault_s < 0.0 && sample.time_s > plan.until_s && sample.motion.v_mps > 0.2)
            row.after_fault_s = sample.time_s - plan.until_s;
    }
    for (const nav::GuardEvent& event : drive.stops) {
        if (event.action != nav::GuardAction::Stop) continue;
        if (event.time_s < plan.from_s) {
            row.stops_before += event.time_s > 1.0 && is_of_the_sensor(event.reason);
        } else if (event.time_s < plan.until_s && row.reason == "-") {
            row.reason = nav::to_string(event.reason);
        }
    }
    if (row.reason == "-" && row.stop_s >= 0.0) row.reason = "navigator";
}

void explain(const drive::DriveResult& drive, const FaultPlan& plan) {
    std::cerr << to_string(plan.fault) << " seed " << plan.seed << " from " << plan.from_s << " to "
              << plan.until_s << ": " << to_string(drive.outcome) << " after " << drive.time_s << " s, "
              << drive.why << "\n";
    for (const nav::GuardEvent& event : drive.stops) {
        std::cerr << "  " << event.time_s << " " << nav::to_string(event.action) << " "
                  << nav::to_string(event.reason) << ": " << event.why << "\n";
    }
    for (std::size_t i = 0; i < drive.samples.size(); i += 50) {
        const drive::DriveSample& s = drive.samples[i];
        std::cerr << "  " << s.time_s << " at " << s.T_world_robot.x_m << " " << s.T_world_robot.y_m << " "
                  << s.T_world_robot.yaw_rad << " believes " << s.T_map_robot.x_m << " " << s.T_map_robot.y_m
                  << " proposed " << s.proposed.v_mps << " " << s.proposed.omega_radps << " command "
                  << s.command.v_mps << " " << s.command.omega_radps << "\n";
    }
}

}  // namespace

Scenario::Scenario(const ScenarioOptions& options, std::uint64_t seed) : options_(options), seed_(seed) {
    drive::DriveObserver nobody;
    nominal_ = drive::simulate_drive(drive_options(), nobody);
}

drive::SimulatedDriveOptions Scenario::drive_options() const {
    drive::SimulatedDriveOptions drive;
    drive.world = make_world(seed_);
    drive.start = drive.world.start;
    drive.goals_m = {*drive.world.goal};
    drive.sensor = options_.sensor;
    drive.timeout_s = 120.0;
    drive.config.navigation.navigator = options_.navigator;
    drive.odometry.seed = seed_;
    CameraModel& camera = drive.camera.camera;
    camera.width_px = options_.width_px;
    camera.height_px = options_.height_px;
    camera.fx_px = camera.fy_px = options_.width_px / 2.0;  // 90 degrees
    camera.cx_px = (options_.width_px - 1) / 2.0;
    camera.cy_px = (options_.height_px - 1) / 2.0;
    camera.mount.height_m = 0.5;
    drive.camera.supersampling = 1;
    camera.mount.pitch_rad = 20.0 * degree_rad;
    drive.camera.rate_hz = 25.0;
    drive.camera.effects.noise_sigma = 2.0;
    drive.camera.effects.seed = seed_;
    return drive;
}

drive::DriveSample Scenario::moment_of(Fault fault) const {
    std::vector<drive::DriveSample> steady;
    for (const drive::DriveSample& sample : nominal_.samples) {
        const bool far_enough = sample.T_world_robot.x_m > 0.6 && sample.T_world_robot.x_m < 2.6;
        if (far_enough && sample.motion.v_mps > 0.25) steady.push_back(sample);
    }
    if (steady.empty()) return nominal_.samples[nominal_.samples.size() / 2];
    const double share = chance(seed_, 1000 + static_cast<std::uint64_t>(fault));
    return steady[static_cast<std::size_t>(share * static_cast<double>(steady.size()))];
}

void Scenario::break_drive(drive::SimulatedDriveOptions& drive, const FaultPlan& plan,
                           const drive::DriveSample& at, RunRow& row) const {
    drive::DriveFaults& faults = drive.faults;
    const double start_s = 1767225600;  // epoch of the simulated fields
    auto broken = std::make_shared<BrokenFields>(plan);
    faults.field = [broken, start_s](const Field& field) {
        return (*broken)(field, field.timestamp_s - start_s);
    };
    faults.field_delay_s = [plan](double time_s) {
        return plan.fault == Fault::Delayed && plan.holds(time_s) ? 1.0 : 0.0;
    };
    faults.odometry = [plan](double time_s, const Pose2& pose) {
        return broken_odometry(plan, time_s, pose);
    };
    // The guard alone must stop before the object, so the navigator drives on at full speed.
    const MotionCommand blindly{drive.config.navigation.robot.v_max_mps, 0.0};
    drive.navigator = [plan, blindly](double time_s,
                                      const MotionCommand& proposed) -> std::optional<MotionCommand> {
        if (plan.fault == Fault::NavigatorHung && plan.holds(time_s)) return std::nullopt;
        return plan.fault == Fault::Mover && plan.holds(time_s) ? blindly : proposed;
    };
    if (plan.fault != Fault::Mover) return;
    row.distance_m = options_.mover_near_m + options_.mover_spread_m * chance(plan.seed, 20);
    drive.world.solids.push_back(mover(plan, at.T_world_robot, 0.25 + row.distance_m));
}

RunRow Scenario::run(Fault fault) {
    const double begin_s = cpu_seconds();
    const drive::DriveSample at = moment_of(fault);
    const double lasts_s = fault == Fault::Mover ? 2.0 * options_.fault_s : options_.fault_s;
    const FaultPlan plan{fault, at.time_s, at.time_s + lasts_s, seed_};
    RunRow row;
    row.fault = fault;
    row.seed = seed_;
    drive::SimulatedDriveOptions drive = drive_options();
    break_drive(drive, plan, at, row);
    drive::DriveObserver nobody;
    const drive::DriveResult result = drive::simulate_drive(drive, nobody);
    const RobotModel& robot = drive.config.navigation.robot;
    row.speed_mps = at.motion.v_mps;
    // The first frozen image is still valid.
    const double unknowable_s = fault == Fault::Frozen ? 1.0 / drive.camera.rate_hz : 0.0;
    row.allowed_s =
        unknowable_s + reaction_s + robot.delay_s + tick_s +
        std::max(at.motion.v_mps / robot.brake_mps2, std::abs(at.motion.omega_radps) / robot.alpha_radps2);
    // An object may be far ahead: the robot must stand before the object leaves.
    if (fault == Fault::Mover) row.allowed_s = lasts_s;
    measure(result, plan, row);
    if (options_.explain) explain(result, plan);
    row.cpu_s = cpu_seconds() - begin_s;
    return row;
}

}  // namespace flownav
