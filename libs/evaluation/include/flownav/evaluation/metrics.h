#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flownav/evaluation/field_row.h"
#include "flownav/evaluation/pose_track.h"

namespace flownav::evaluation {

/// Errors of the flow odometry against another track of poses. A figure is empty when there are no data for
/// it. Poses of the other track are interpolated at the times of the fields. The figures of omega and v leave
/// out the first `settling_fields` fields; the end figures do not.
struct Errors {
    static constexpr std::size_t settling_fields = 10;

    std::uint64_t fields_compared = 0;            ///< fields inside the span of the other track
    std::optional<double> path_m;                 ///< length of the other track over the compared fields
    std::optional<double> omega_rms_degps;        ///< rms of the error per field
    std::optional<double> omega_cycle_rms_degps;  ///< rms of the mean error over a cycle
    std::optional<double> v_bias_percent;      ///< of cycles with measured speed and a true speed > 0.05 m/s
    std::optional<double> v_sd_percent;        ///< of the cycles of v_bias_percent
    std::optional<double> t_measured_percent;  ///< share of finished cycles with measured speed
    std::optional<double> end_position_percent;  ///< distance of the end positions, in percent of path_m
    std::optional<double> heading_end_deg;       ///< > 0: flow odometry ends too far to the left
};

/// Compares flow odometry with another track; PoseTrack::finish() must have been called.
Errors compare(const std::vector<FieldRow>& rows, const PoseTrack& track);

/// Name, unit and meaning of a figure of Errors.
struct Figure {
    const char* name;
    const char* unit;
    const char* meaning;
    std::optional<double> Errors::*value;
};

/// All figures in the order of the outputs.
const std::array<Figure, 8>& error_figures();

}  // namespace flownav::evaluation
