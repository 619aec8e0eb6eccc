#include "other_sensors.h"

#include <algorithm>
#include <cmath>

namespace flownav::pipeline {
namespace {

constexpr double outlier = 3.0;      // standard deviations from which two values are not averaged
constexpr double flow_scale = 0.01;  // error of the flow's travel by height and pitch of the camera, relative
// Readings farther from a field are those of another clock, or of a sensor that fell silent.
constexpr double late_s = 1.0;
constexpr int late_fields = 10;
// Wheels that turn less within this time stand.
constexpr double standing_s = 0.4;
constexpr double standing_m = 0.0005;
constexpr double standing_rad = 0.0005;

/// See averaged(), for one part.
void average(double& value, double& sigma, MotionSource& source, const ToldValue& told) {
    const double variance = sigma * sigma;
    const double told_variance = told.sigma * told.sigma;
    const double difference = told.value - value;
    const bool differs = difference * difference > outlier * outlier * (variance + told_variance);
    if (differs && !told.outdoes_flow) return;
    const double gain = differs ? 1.0 : variance / std::max(variance + told_variance, 1e-18);
    value += gain * difference;
    sigma = differs ? told.sigma : std::sqrt((1.0 - gain) * variance);
    if (gain > 0.5) source = told.source;
}

SensorCheck check_of(const motion::Agreement& agreement, bool has_readings, int late) {
    if (!has_readings) return {};
    if (late >= late_fields) return {SensorAgreement::NotInTime, agreement.ratio()};
    return {agreement.verdict(), agreement.ratio()};
}

bool believed(const SensorCheck& check) {
    return check.agreement == SensorAgreement::Unchecked || check.agreement == SensorAgreement::Agrees;
}

}  // namespace

EgoMotion completed(EgoMotion motion, const ToldMotion& told) {
    const bool turn_told = !motion.omega_measured && told.turn.has_value();
    const bool way_told = !motion.forward_measured && told.way.has_value();
    if (turn_told) {
        motion.omega_rad = told.turn->value;
        motion.sigma_omega_rad = told.turn->sigma;
        motion.omega_source = told.turn->source;
        motion.omega_measured = true;
    }
    if (way_told) {
        motion.forward_m = told.way->value;
        motion.sigma_forward_m = told.way->sigma;
        motion.forward_source = told.way->source;
        motion.forward_measured = true;
    }
    if (turn_told && way_told) motion.chord_rad = told.chord_rad;
    return motion;
}

EgoMotion averaged(EgoMotion motion, const ToldMotion& told) {
    if (motion.omega_measured && told.turn && told.turn->is_prior())
        average(motion.omega_rad, motion.sigma_omega_rad, motion.omega_source, *told.turn);
    if (motion.forward_measured && told.way && told.way->is_prior())
        average(motion.forward_m, motion.sigma_forward_m, motion.forward_source, *told.way);
    return motion;
}

std::optional<Pose2> told_pose(const ToldMotion& told) {
    if (!told.turn || !told.way) return std::nullopt;
    return along_arc(told.turn->value, told.way->value, told.chord_rad);
}

void OtherSensors::note(const WheelPose& reading) {
    if (params_.wheels != SensorUse::Off) wheels_.note(reading);
}

void OtherSensors::note(const GyroRate& reading) {
    if (params_.gyro != SensorUse::Off) gyro_.note(reading);
}

ToldMotion OtherSensors::between(double from_s, double to_s) const {
    ToldMotion told;
    const SensorChecks checks = this->checks();
    const auto wheels = wheels_.between(from_s, to_s);
    if (wheels && believed(checks.wheels_way)) {
        const Pose2& moved = wheels->T_from_to;
        told.way =
            ToldValue{motion::chord_m(moved), wheels->sigma_forward_m, MotionSource::Wheels, params_.wheels};
        const double back_rad = told.way->value < 0.0 ? M_PI : 0.0;
        if (std::abs(told.way->value) > standing_m)
            told.chord_rad = wrap_angle(std::atan2(moved.y_m, moved.x_m) - back_rad - moved.yaw_rad / 2);
    }
    if (wheels && believed(checks.wheels_turn))
        told.turn = ToldValue{wheels->T_from_to.yaw_rad, wheels->sigma_turn_rad, MotionSource::Wheels,
                              params_.wheels};
    const auto gyro = gyro_.between(from_s, to_s);
    if (gyro && believed(checks.gyro))
        told.turn = ToldValue{gyro->omega_rad, gyro->sigma_rad, MotionSource::Gyro, params_.gyro,
                              checks.gyro.agreement == SensorAgreement::Agrees};
    return told;
}

void OtherSensors::compare(double from_s, double to_s, const EgoMotion& flow) {
    compare_wheels(from_s, to_s, flow);
    compare_gyro(from_s, to_s, flow);
}

void OtherSensors::compare_wheels(double from_s, double to_s, const EgoMotion& flow) {
    const auto wheels = wheels_.between(from_s, to_s);
    if (!wheels) return;
    if (flow.omega_measured) {
        turn_.note({to_s, flow.omega_rad, wheels->T_from_to.yaw_rad,
                    std::hypot(flow.sigma_omega_rad, wheels->sigma_turn_rad)});
    }
    if (flow.forward_measured) {
        const double sigma_m = std::hypot(flow.sigma_forward_m, flow_scale * flow.forward_m);
        way_.note({to_s, flow.forward_m, motion::chord_m(wheels->T_from_to),
                   std::hypot(sigma_m, wheels->sigma_forward_m)});
    }
}

void OtherSensors::compare_gyro(double from_s, double to_s, const EgoMotion& flow) {
    const auto gyro = gyro_.between(from_s, to_s);
    if (!gyro || !flow.omega_measured) return;
    gyro_turn_.note(
        {to_s, flow.omega_rad, gyro->omega_rad, std::hypot(flow.sigma_omega_rad, gyro->sigma_rad)});
    gyro_.learn_bias(from_s, to_s, flow.omega_rad, flow.sigma_omega_rad);
}

void OtherSensors::note_field(double timestamp_s) {
    const auto count_late = [timestamp_s](int& late, double newest_s) {
        late = std::abs(timestamp_s - newest_s) > late_s ? std::min(late + 1, late_fields) : 0;
    };
    if (!wheels_.empty()) count_late(wheels_late_, wheels_.newest_s());
    if (!gyro_.empty()) count_late(gyro_late_, gyro_.newest_s());
    const auto wheels = wheels_.between(timestamp_s - standing_s, timestamp_s);
    if (!wheels || timestamp_s - stood_s_ < standing_s) return;
    const bool stands = std::abs(motion::chord_m(wheels->T_from_to)) < standing_m &&
                        std::abs(wheels->T_from_to.yaw_rad) < standing_rad;
    if (!stands) return;
    gyro_.learn_bias(timestamp_s - standing_s, timestamp_s, 0.0, 0.0);
    stood_s_ = timestamp_s;
}

SensorChecks OtherSensors::checks() const {
    SensorChecks checks;
    checks.wheels_way = check_of(way_, !wheels_.empty(), wheels_late_);
    checks.wheels_turn = check_of(turn_, !wheels_.empty(), wheels_late_);
    checks.gyro = check_of(gyro_turn_, !gyro_.empty(), gyro_late_);
    checks.gyro_bias_radps = gyro_.bias_radps();
    return checks;
}

}  // namespace flownav::pipeline
