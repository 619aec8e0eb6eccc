#include "flownav/evaluation/csv_files.h"

#include <cmath>
#include <initializer_list>
#include <string>

#include "flownav/cli/number_text.h"
#include "flownav/evaluation/field_row.h"

namespace flownav::evaluation {

namespace {

/// The cells with commas between them.
std::string joined(std::initializer_list<std::string> cells) {
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + cell;
    return line;
}

std::string row(std::initializer_list<std::string> cells) {
    return joined(cells) + '\n';
}

constexpr auto motion_columns =
    "timestamp,status,omega_radps,pitch_rate_radps,v_mps,v_measured,image_of_cycle,placed,confident,"
    "inliers,ground_window,obstacles,carried_s,carried_sigma_m,carried_sigma_rad";
constexpr auto source_columns = "omega_source,forward_source";
constexpr auto contact_columns =
    "contact_gate,floor_fit,vignetting,strips_free,strips_obstacle,strips_unknown";

std::string motion_cells(const pipeline::Step& step) {
    const bool pitch_known = step.status == FieldStatus::Ok;
    const bool turn_known = pitch_known || step.motion.omega_measured;
    const bool speed_known = step.status != FieldStatus::Waiting;
    return joined({cli::time_text(step.timestamp_s), to_string(step.status),
                   turn_known ? cli::fixed_text(step.omega_radps, 6) : "",
                   pitch_known ? cli::fixed_text(step.pitch_rate_radps, 6) : "",
                   speed_known ? cli::fixed_text(step.v_mps, 6) : "", step.v_measured ? "1" : "0",
                   std::to_string(step.image_of_cycle), std::to_string(step.counts.placed),
                   std::to_string(step.counts.confident), std::to_string(step.counts.inliers),
                   std::to_string(step.counts.ground_window), std::to_string(step.obstacles.size()),
                   cli::fixed_text(step.carried.since_s, 6), cli::fixed_text(step.carried.sigma_m, 4),
                   cli::fixed_text(step.carried.sigma_rad, 5)});
}

/// Empty while there is no motion.
std::string source_cells(const pipeline::Step& step) {
    if (step.status == FieldStatus::Waiting) return ",";
    return joined({to_string(step.motion.omega_source), to_string(step.motion.forward_source)});
}

/// The floor was registered, and is told, behind the gate of a poor floor too.
std::string contact_cells(const ContactRow& contacts) {
    if (!contacts.is_new) return ",,,,,";
    const std::string gate = to_string(contacts.gate);
    if (!contacts.is_scanned() && contacts.gate != ContactGate::PoorFloor) return gate + ",,,,,";
    const std::string floor =
        joined({gate, cli::fixed_text(contacts.fit_share, 4), cli::fixed_text(contacts.vignetting, 4)});
    if (!contacts.is_scanned()) return floor + ",,,";
    return joined({floor, std::to_string(contacts.strips.free), std::to_string(contacts.strips.obstacle),
                   std::to_string(contacts.strips.unknown)});
}

/// Cause, distances, score and place of a strip whose middle has the tangent `right`.
std::string strip_cells(const ContactScan& scan, const ContactStrip& strip, double right) {
    const std::string free_m = cli::fixed_text(strip.free_m, 4);
    if (strip.kind != BeamKind::Obstacle) return "," + free_m + ",,,,,,";
    const Eigen::Vector2d at_m = point_of(scan, right, strip.contact_m);
    return joined({to_string(strip.cause), free_m, cli::fixed_text(strip.contact_m, 4),
                   cli::fixed_text(strip.near_m, 4), cli::fixed_text(strip.far_m, 4),
                   cli::fixed_text(strip.score, 1), cli::fixed_text(at_m.x(), 4),
                   cli::fixed_text(at_m.y(), 4)});
}

}  // namespace

EgomotionCsv::EgomotionCsv(const std::filesystem::path& path) : file_(path) {
    file_.write(row({motion_columns, source_columns, contact_columns}));
}

void EgomotionCsv::write(const pipeline::Step& step) {
    file_.write(row({motion_cells(step), source_cells(step), contact_cells(contact_row_of(step))}));
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

ContactsCsv::ContactsCsv(const std::filesystem::path& path) : file_(path) {
    file_.write(
        "timestamp,tangent_right,bearing_rad,kind,seen,cause,free_m,contact_m,near_m,far_m,score,x_m,y_m\n");
}

void ContactsCsv::write(const pipeline::Step& step) {
    if (!step.new_contacts || step.contacts.gate != ContactGate::Open) return;
    const ContactScan& scan = step.contacts;
    for (std::size_t i = 0; i < scan.strips.size(); ++i) {
        const ContactStrip& strip = scan.strips[i];
        const double right = middle_tangent(scan, static_cast<int>(i));
        file_.write(row({cli::time_text(step.timestamp_s), cli::fixed_text(right, 4),
                         cli::fixed_text(scan.T_robot_scan.yaw_rad - std::atan(right), 4),
                         to_string(strip.kind), strip.seen ? "1" : "0", strip_cells(scan, strip, right)}));
    }
}

}  // namespace flownav::evaluation
