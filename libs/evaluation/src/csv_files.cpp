#include "flownav/evaluation/csv_files.h"

#include <initializer_list>
#include <string>

#include "flownav/cli/number_text.h"

namespace flownav::evaluation {

namespace {

std::string row(std::initializer_list<std::string> cells) {
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + cell;
    return line + '\n';
}

}  // namespace

EgomotionCsv::EgomotionCsv(const std::filesystem::path& path) : file_(path) {
    file_.write(
        "timestamp,status,omega_radps,pitch_rate_radps,v_mps,v_measured,image_of_cycle,placed,confident,"
        "inliers,ground_window,obstacles,carried_s,carried_sigma_m,carried_sigma_rad,"
        "omega_source,v_source\n");
}

void EgomotionCsv::write(const pipeline::Step& step) {
    const bool pitch_known = step.status == FieldStatus::Ok;
    const bool turn_known = pitch_known || step.motion.omega_measured;
    const bool speed_known = step.status != FieldStatus::Waiting;
    file_.write(row({cli::time_text(step.timestamp_s), to_string(step.status),
                     turn_known ? cli::fixed_text(step.omega_radps, 6) : "",
                     pitch_known ? cli::fixed_text(step.pitch_rate_radps, 6) : "",
                     speed_known ? cli::fixed_text(step.v_mps, 6) : "", step.v_measured ? "1" : "0",
                     std::to_string(step.image_of_cycle), std::to_string(step.counts.placed),
                     std::to_string(step.counts.confident), std::to_string(step.counts.inliers),
                     std::to_string(step.counts.ground_window), std::to_string(step.obstacles.size()),
                     cli::fixed_text(step.carried.since_s, 6), cli::fixed_text(step.carried.sigma_m, 4),
                     cli::fixed_text(step.carried.sigma_rad, 5), to_string(step.motion.omega_source),
                     to_string(step.motion.forward_source)}));
}

ObstaclesCsv::ObstaclesCsv(const std::filesystem::path& path) : file_(path) {
    file_.write("timestamp,x_m,y_m,z_m,sigma_m,u_px,v_px\n");
}

void ObstaclesCsv::write(const pipeline::Step& step) {
    for (const ObstaclePoint& point : step.obstacles) {
        file_.write(row({cli::time_text(step.timestamp_s), cli::fixed_text(point.position_m.x(), 4),
                         cli::fixed_text(point.position_m.y(), 4), cli::fixed_text(point.position_m.z(), 4),
                         cli::fixed_text(point.sigma_m, 4), cli::fixed_text(point.at_px.x(), 2),
                         cli::fixed_text(point.at_px.y(), 2)}));
    }
}

}  // namespace flownav::evaluation
