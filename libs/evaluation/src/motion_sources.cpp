#include "flownav/evaluation/motion_sources.h"

#include "finding_text.h"

namespace flownav::evaluation {
namespace {

void add(SensorHistory& history, const SensorCheck& check, double since_field_s) {
    history.last = check;
    if (check.agreement == SensorAgreement::NotInTime) history.not_in_time_s += since_field_s;
    if (check.agreement != SensorAgreement::Contradicts) return;
    history.contradicted_s += since_field_s;
    history.contradicted_ratio = check.ratio;
}

std::string seconds(double time_s) {
    return cli::fixed_text(time_s, 1) + " s";
}

std::string contradiction(const SensorHistory& history, const std::string& what, const std::string& key,
                          const std::string& causes) {
    return what + " contradicted the flow for " + seconds(history.contradicted_s) + " (told " +
           cli::fixed_text(history.contradicted_ratio, 2) +
           " times what the flow measured) and was not used meanwhile: check " + causes + ", or set " + key +
           " = off" + findings_page;
}

std::string other_clock(const SensorHistory& history, const std::string& what, const std::string& key) {
    return "the times of " + what + " were more than 1 s from those of the images for " +
           seconds(history.not_in_time_s) +
           ": it was not used meanwhile; record both with one clock, or set " + key + " = off" +
           findings_page;
}

}  // namespace

MotionSources motion_sources(const std::vector<FieldRow>& rows) {
    MotionSources sources;
    double before_s = rows.empty() ? 0.0 : rows.front().timestamp_s;
    for (const FieldRow& row : rows) {
        const double since_field_s = row.timestamp_s - before_s;
        before_s = row.timestamp_s;
        ++sources.turn.at(static_cast<std::size_t>(row.omega_source));
        ++sources.way.at(static_cast<std::size_t>(row.forward_source));
        add(sources.wheels_way, row.other_sensors.wheels_way, since_field_s);
        add(sources.wheels_turn, row.other_sensors.wheels_turn, since_field_s);
        add(sources.gyro, row.other_sensors.gyro, since_field_s);
        sources.gyro_bias_radps = row.other_sensors.gyro_bias_radps;
    }
    return sources;
}

std::vector<Finding> sensor_findings(const std::vector<FieldRow>& rows) {
    const MotionSources sources = motion_sources(rows);
    std::vector<Finding> findings;
    if (sources.wheels_way.contradicted_s > 0.0)
        findings.push_back(
            {"wheels_way", contradiction(sources.wheels_way, "the way of the wheels", "motion.wheels",
                                         "slip, the size of the wheels, camera.height_m and clocks")});
    if (sources.wheels_turn.contradicted_s > 0.0)
        findings.push_back(
            {"wheels_turn", contradiction(sources.wheels_turn, "the turn of the wheels", "motion.wheels",
                                          "slip, the sign, the track and clocks")});
    if (sources.gyro.contradicted_s > 0.0)
        findings.push_back({"gyro_turn", contradiction(sources.gyro, "the turn of the gyro", "motion.gyro",
                                                       "its axis, sign and scale, and clocks")});
    if (sources.wheels_way.not_in_time_s > 0.0)
        findings.push_back(
            {"wheels_times", other_clock(sources.wheels_way, "the wheel odometry", "motion.wheels")});
    if (sources.gyro.not_in_time_s > 0.0)
        findings.push_back({"gyro_times", other_clock(sources.gyro, "the gyro", "motion.gyro")});
    return findings;
}

}  // namespace flownav::evaluation
