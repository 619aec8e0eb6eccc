#pragma once
#include <array>

namespace flownav {

/// Result of comparing another sensor of motion with the flow.
enum class SensorAgreement {
    NoReadings,   ///< switched off, or no reading has come
    Unchecked,    ///< flow and sensor have not measured enough motion together yet
    Agrees,       ///< flow and sensor tell the same motion
    Contradicts,  ///< they do not; the sensor is not used
    NotInTime,    ///< the times of the readings are far from those of the fields; the sensor is not used
};

constexpr std::array<SensorAgreement, 5> all_sensor_agreements = {
    SensorAgreement::NoReadings, SensorAgreement::Unchecked, SensorAgreement::Agrees,
    SensorAgreement::Contradicts, SensorAgreement::NotInTime};

/// Name of an agreement, as written to files.
const char* to_string(SensorAgreement agreement);

/// One quantity of another sensor, compared with the flow over the last seconds.
struct SensorCheck {
    SensorAgreement agreement = SensorAgreement::NoReadings;
    double ratio = 1.0;  ///< what the sensor told over what the flow measured; 1 as long as it is not known
};

/// Comparison of wheels and gyro with the flow.
struct SensorChecks {
    SensorCheck wheels_way;
    SensorCheck wheels_turn;
    SensorCheck gyro;
    double gyro_bias_radps = 0.0;  ///< learnt so far; taken off the readings
};

}  // namespace flownav
