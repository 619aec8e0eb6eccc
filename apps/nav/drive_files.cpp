#include "drive_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "flownav/replay/number_text.h"

namespace flownav {
namespace {

constexpr double barn_speed_mps = 2.0;

double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

std::string columns(const Pose2& pose) {
    return fixed_text(pose.x_m, 4) + ',' + fixed_text(pose.y_m, 4) + ',' + fixed_text(pose.yaw_rad, 5);
}

std::string columns(const MotionCommand& motion) {
    return fixed_text(motion.v_mps, 3) + ',' + fixed_text(motion.omega_radps, 3);
}

}  // namespace

double barn_score(const DriveResult& result, double reference_path_m) {
    if (result.outcome != Outcome::Reached) return 0.0;
    const double optimal_s = reference_path_m / barn_speed_mps;
    return optimal_s / std::clamp(result.time_s, 2.0 * optimal_s, 8.0 * optimal_s);
}

std::string result_json(const NavOptions& options, const DriveResult& result) {
    nlohmann::ordered_json json;
    json["outcome"] = to_string(result.outcome);
    json["why"] = result.why;
    json["time_s"] = rounded(result.time_s);
    json["path_m"] = rounded(result.path_m);
    if (result.outcome == Outcome::Collision) json["contact_speed_mps"] = rounded(result.contact_speed_mps);
    if (options.reference_path_m > 0.0) json["score"] = rounded(barn_score(result, options.reference_path_m));
    if (options.robot == "sim") {
        json["min_clearance_m"] = rounded(result.min_clearance_m);
        json["world"] = options.drive.world.name;
        json["seed"] = options.seed;
    }
    json["sensor"] = options.drive.sensor == SensorKind::Flow ? "flow" : "lidar";
    json["navigator"] =
        options.drive.config.navigation.navigator == NavigatorKind::Lanes ? "lanes" : "reactive";
    json["stops"] = nlohmann::ordered_json::array();
    for (const nav::GuardEvent& stop : result.stops) {
        if (stop.action == nav::GuardAction::Pass) continue;
        json["stops"].push_back({{"time_s", rounded(stop.time_s)},
                                 {"action", to_string(stop.action)},
                                 {"reason", to_string(stop.reason)},
                                 {"why", stop.why}});
    }
    return json.dump(2) + '\n';
}

std::string drive_csv_header() {
    return "time_s,true_x_m,true_y_m,true_yaw_rad,map_x_m,map_y_m,map_yaw_rad,odom_x_m,odom_y_m,"
           "odom_yaw_rad,v_mps,omega_radps,proposed_v_mps,proposed_omega_radps,command_v_mps,"
           "command_omega_radps,waypoint_x_m,waypoint_y_m,clearance_m,state,action,why\n";
}

std::string drive_csv_row(const DriveSample& sample, const nav::Autopilot& autopilot) {
    const nav::PilotDecision& decision = autopilot.decision();
    std::string why = decision.why;
    std::replace(why.begin(), why.end(), ',', ';');
    return fixed_text(sample.time_s, 2) + ',' + columns(sample.T_world_robot) + ',' +
           columns(sample.T_map_robot) + ',' + columns(sample.odometry) + ',' + columns(sample.motion) + ',' +
           columns(sample.proposed) + ',' + columns(sample.command) + ',' +
           fixed_text(decision.waypoint_m.x(), 3) + ',' + fixed_text(decision.waypoint_m.y(), 3) + ',' +
           fixed_text(sample.clearance_m, 3) + ',' + to_string(decision.state) + ',' +
           to_string(autopilot.verdict().action) + ',' + why + '\n';
}

}  // namespace flownav
