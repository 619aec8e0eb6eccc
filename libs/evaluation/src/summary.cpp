#include "flownav/evaluation/summary.h"

#include <array>
#include <cmath>
#include <utility>

#include "flownav/core/version.h"
#include "flownav/evaluation/contact_figures.h"
#include "flownav/evaluation/motion_sources.h"
#include "flownav/evaluation/summary_facts.h"
#include "flownav/math/units.h"

namespace flownav::evaluation {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_stretches = 250;

/// Rounds to six decimals, as in the CSV files; null when not finite.
Json rounded(double value) {
    if (!std::isfinite(value)) return nullptr;
    return std::round(value * 1e6) / 1e6 + 0.0;  // + 0.0 turns -0 into 0
}

Json rounded(const std::optional<double>& value) {
    return value ? rounded(*value) : Json(nullptr);
}

Json input_part(const Drive& drive) {
    return {{"file", drive.input_name},
            {"end", end_word(drive)},
            {"message", drive.stop_reason.empty() ? drive.end.message : drive.stop_reason},
            {"objects_read", drive.end.objects_read},
            {"byte_offset", drive.end.byte_offset}};
}

Json read_part(const io::InputCounts& read) {
    return {{"objects", read.objects},
            {"images", read.images},
            {"fields", read.fields},
            {"odometry", read.odometry},
            {"ground_truth", read.ground_truth},
            {"gyro", read.gyro},
            {"ignored", read.ignored},
            {"observations", Json(read.observations)}};
}

Json written_part(const WrittenCounts& written) {
    return {{"trajectory_poses", written.trajectory_poses},     {"odometry_poses", written.odometry_poses},
            {"ground_truth_poses", written.ground_truth_poses}, {"egomotion_rows", written.egomotion_rows},
            {"obstacle_points", written.obstacle_points},       {"cycles", written.cycles},
            {"map_occupied_cells", written.map_cells.occupied}, {"map_free_cells", written.map_cells.free},
            {"result_rawlog", Json(written.result_rawlog)}};
}

Json status_part(const std::vector<FieldRow>& rows) {
    const auto counts = status_counts(rows);
    Json part;
    for (std::size_t i = 0; i < counts.size(); ++i) part[to_string(all_field_statuses.at(i))] = counts[i];
    return part;
}

Json fault_part(const FieldFaultCounts& faults) {
    Json part;
    for (const FieldFault fault : all_field_faults) {
        if (fault == FieldFault::None) continue;
        part[to_string(fault)] = faults.at(static_cast<std::size_t>(fault));
    }
    return part;
}

Json drive_part(const std::vector<FieldRow>& rows) {
    if (rows.empty()) return nullptr;
    double path_m = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const Pose2& a = rows[i - 1].T_start_robot;
        const Pose2& b = rows[i].T_start_robot;
        path_m += std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
    }
    const Pose2& end = rows.back().T_start_robot;
    const CarriedTime carried = carried_time(rows);
    return {{"start_s", rounded(rows.front().timestamp_s)},
            {"duration_s", rounded(rows.back().timestamp_s - rows.front().timestamp_s)},
            {"path_m", rounded(path_m)},
            {"end_x_m", rounded(end.x_m)},
            {"end_y_m", rounded(end.y_m)},
            {"end_heading_deg", rounded(deg(end.yaw_rad))},
            {"carried_s", rounded(carried.total_s)},
            {"carried_longest_s", rounded(carried.longest_s)},
            {"carried_sigma_m", rounded(carried.sigma_m)}};
}

Json source_counts(const SourceCounts& counts) {
    Json part;
    for (const MotionSource source :
         {MotionSource::Flow, MotionSource::Wheels, MotionSource::Gyro, MotionSource::Prediction})
        part[to_string(source)] = counts.at(static_cast<std::size_t>(source));
    return part;
}

Json motion_part(const std::vector<FieldRow>& rows) {
    const MotionSources sources = motion_sources(rows);
    Json part = {{"turn", source_counts(sources.turn)}, {"way", source_counts(sources.way)}};
    const auto enter = [&part](const std::string& name, const SensorHistory& history) {
        part[name] = to_string(history.last.agreement);
        part[name + "_ratio"] = rounded(history.last.ratio);
        part[name + "_contradicted_s"] = rounded(history.contradicted_s);
        part[name + "_not_in_time_s"] = rounded(history.not_in_time_s);
    };
    enter("wheels_way", sources.wheels_way);
    enter("wheels_turn", sources.wheels_turn);
    enter("gyro", sources.gyro);
    part["gyro_bias_degps"] = rounded(deg(sources.gyro_bias_radps));
    return part;
}

Json contacts_part(const ContactFigures& figures) {
    Json gates, causes;
    for (const ContactGate gate : all_contact_gates)
        gates[to_string(gate)] = figures.by_gate.at(static_cast<std::size_t>(gate));
    for (const BeamCause cause : all_beam_causes)
        if (cause != BeamCause::None)
            causes[to_string(cause)] = figures.by_cause.at(static_cast<std::size_t>(cause));
    return {{"scans", figures.scans},
            {"rows", figures.rows},
            {"scanned_percent", rounded(figures.scanned_percent)},
            {"by_gate", std::move(gates)},
            {"free_strips", rounded(figures.free_strips)},
            {"contacts", rounded(figures.contacts)},
            {"unknown_strips", rounded(figures.unknown_strips)},
            {"decided_2m_percent", rounded(figures.decided_percent)},
            {"by_cause", std::move(causes)},
            {"floor_fit", rounded(figures.fit_share)},
            {"vignetting", rounded(figures.vignetting)}};
}

Json errors_part(const std::optional<Errors>& errors) {
    if (!errors) return nullptr;
    Json part = {{"fields_compared", errors->fields_compared}};
    for (const Figure& figure : error_figures()) {
        const std::optional<double>& value = (*errors).*figure.value;
        part[figure.name] = rounded(value);
    }
    return part;
}

Json findings_part(const std::vector<Finding>& findings) {
    Json part = Json::array();
    for (const Finding& finding : findings)
        part.push_back(
            {{"reason", finding.reason}, {"sentence", finding.sentence}, {"loses_data", finding.loses_data}});
    return part;
}

Json camera_check_part(const CameraCheck& check) {
    const auto angle = [&check](const motion::MountAngles& angles, int i) {
        return check.angles_known ? rounded(deg(angles[i])) : Json(nullptr);
    };
    Json part = {
        {"verdict", check.verdict}, {"pairs", check.pairs}, {"agreeing_share", rounded(check.agreeing)}};
    const std::array<const char*, 3> names = {"pitch", "roll", "yaw"};
    for (int i = 0; i < 3; ++i) {
        const std::string name = names.at(static_cast<std::size_t>(i));
        part[name + "_error_deg"] = angle(check.angles.correction_rad, i);
        part[name + "_sigma_deg"] = angle(check.angles.sigma_rad, i);
    }
    part["odometry_ratio"] = check.scale ? rounded(check.scale->ratio) : Json(nullptr);
    part["odometry_ratio_sigma"] = check.scale ? rounded(check.scale->sigma) : Json(nullptr);
    part["warnings"] = Json(check.warnings);
    return part;
}

Json config_part(const config::Config& config) {
    Json part = Json::object();
    for (const config::ConfigKey& key : config::config_keys()) {
        part[key.section][key.name] = config::config_value(config, key.full_name());
    }
    return part;
}

/// Milliseconds per field, as means over at most `most_stretches` stretches of the drive.
Json times_per_field(const std::vector<FieldTimes>& fields) {
    const std::size_t stretches = std::min(most_stretches, fields.size());
    Json times = {{"t_s", Json::array()}};
    for (const NamedStage& stage : all_stages) times[std::string(stage.name) + "_ms"] = Json::array();
    for (std::size_t i = 0; i < stretches; ++i) {
        const std::size_t from = i * fields.size() / stretches;
        const std::size_t to = (i + 1) * fields.size() / stretches;
        times["t_s"].push_back(rounded(fields[from].timestamp_s - fields.front().timestamp_s));
        for (const NamedStage& stage : all_stages) {
            double sum_s = 0.0;
            for (std::size_t k = from; k < to; ++k) sum_s += fields[k].spent.*stage.seconds;
            const double mean_ms = 1000.0 * sum_s / static_cast<double>(to - from);
            times[std::string(stage.name) + "_ms"].push_back(std::round(mean_ms * 1000) / 1000);
        }
    }
    return times;
}

}  // namespace

Json summary_facts(const Drive& drive, const config::Config& config) {
    Json summary;
    summary["program"] = "flownav-replay";
    summary["version"] = version();
    summary["input"] = input_part(drive);
    summary["read"] = read_part(drive.read);
    summary["rejected"] = Json(drive.read.rejected);
    summary["used_nevertheless"] = Json(drive.read.warnings);
    summary["written"] = written_part(drive.written);
    summary["status"] = status_part(drive.rows);
    summary["bad_fields"] = fault_part(drive.field_faults);
    summary["drive"] = drive_part(drive.rows);
    summary["motion"] = motion_part(drive.rows);
    summary["contacts"] = contacts_part(contact_figures(drive.rows));
    summary["errors"] = {{"ground_truth", errors_part(drive.ground_truth_errors)},
                         {"odometry", errors_part(drive.odometry_errors)}};
    summary["warnings"] = findings_part(drive.findings);
    summary["camera_check"] = camera_check_part(drive.camera_check);
    summary["config"] = config_part(config);
    return summary;
}

Json timing_facts(const Timing& timing) {
    const auto fields = static_cast<double>(timing.fields.size());
    const StageTimes& spent = timing.stages;
    Json stages;
    for (const NamedStage& stage : all_stages)
        stages[std::string(stage.name) + "_s"] = rounded(spent.*stage.seconds);
    return {{"decode_s", rounded(spent.decode_s)},
            {"step_s", rounded(spent.match_s + spent.motion_s)},
            {"write_s", rounded(spent.map_s + spent.write_s)},
            {"total_s", rounded(timing.total_s)},
            {"fields_per_s", rounded(timing.total_s > 0 ? fields / timing.total_s : 0.0)},
            {"threads", timing.threads},
            {"kernel", timing.kernel},
            {"stages", std::move(stages)},
            {"per_field", times_per_field(timing.fields)}};
}

std::string summary_json(const Drive& drive, const config::Config& config, const Timing& timing) {
    Json summary = summary_facts(drive, config);
    summary["timing"] = timing_facts(timing);
    const std::string mark = "times per field";
    const Json per_field = std::exchange(summary["timing"]["per_field"], mark);
    // Bytes of a file name that are not UTF-8 are replaced.
    std::string text = summary.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
    const auto at = text.rfind('"' + mark + '"');                // the timing comes last
    return text.replace(at, mark.size() + 2, per_field.dump());  // writes the lists of numbers in one line
}

}  // namespace flownav::evaluation
