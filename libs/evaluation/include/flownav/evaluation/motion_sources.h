#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "flownav/evaluation/field_row.h"
#include "flownav/evaluation/findings.h"

namespace flownav::evaluation {

/// Number of fields whose turn or travel came from each source, in the order of MotionSource.
using SourceCounts = std::array<std::uint64_t, 4>;

/// How one quantity of wheels or gyro agreed with the flow over a drive.
struct SensorHistory {
    SensorCheck last;  ///< of the last field
    double contradicted_s = 0.0;
    double not_in_time_s = 0.0;
    double contradicted_ratio = 1.0;  ///< at the last contradiction: told by the sensor, over the flow
};

/// Where the motion of a drive came from.
struct MotionSources {
    SourceCounts turn{};
    SourceCounts way{};
    SensorHistory wheels_way, wheels_turn, gyro;
    double gyro_bias_radps = 0.0;  ///< of the last field
};

MotionSources motion_sources(const std::vector<FieldRow>& rows);

/// One finding for each sensor that contradicted the flow, or whose times do not fit those of the fields.
std::vector<Finding> sensor_findings(const std::vector<FieldRow>& rows);

}  // namespace flownav::evaluation
