#include "drive_files.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace flownav {
namespace {

constexpr double barn_speed_mps = 2.0;

double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

}  // namespace

double barn_score(const drive::DriveResult& result, double reference_path_m) {
    if (result.outcome != drive::Outcome::Reached) return 0.0;
    const double optimal_s = reference_path_m / barn_speed_mps;
    return optimal_s / std::clamp(result.time_s, 2.0 * optimal_s, 8.0 * optimal_s);
}

std::string result_json(const NavOptions& options, const drive::DriveResult& result, int fields_left_out) {
    nlohmann::ordered_json json;
    json["outcome"] = to_string(result.outcome);
    json["why"] = result.why;
    json["time_s"] = rounded(result.time_s);
    json["path_m"] = rounded(result.path_m);
    if (result.outcome == drive::Outcome::Collision || result.outcome == drive::Outcome::Fell)
        json["contact_speed_mps"] = rounded(result.contact_speed_mps);
    if (options.reference_path_m > 0.0) json["score"] = rounded(barn_score(result, options.reference_path_m));
    if (options.robot == "sim") {
        json["min_clearance_m"] = rounded(result.min_clearance_m);
        json["world"] = options.drive.world.name;
        json["seed"] = options.seed;
    } else {
        json["robot"] = options.robot;
        json["camera"] = options.camera->source;
        json["fields_left_out"] = fields_left_out;
    }
    json["sensor"] = options.drive.sensor == drive::SensorKind::Flow ? "flow" : "lidar";
    json["navigator"] = options.drive.config.navigation.navigator;
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

}  // namespace flownav
