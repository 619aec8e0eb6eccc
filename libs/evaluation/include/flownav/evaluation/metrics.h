#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "flownav/evaluation/field_row.h"
#include "flownav/evaluation/pose_track.h"

namespace flownav::evaluation {

/// How the flow odometry differs from another track of poses. A figure is absent when there is nothing to
/// compute it from. Poses of the other track are interpolated at the times of the fields; the first
/// `settling_fields` fields are left out of the figures of omega and v, not of the end figures.
struct Errors {
    static constexpr std::size_t settling_fields = 10;

    std::uint64_t fields_compared = 0;            ///< fields inside the span of the other track
    std::optional<double> path_m;                 ///< length of the other track over those fields
    std::optional<double> omega_rms_degps;        ///< per field
    std::optional<double> omega_cycle_rms_degps;  ///< of the mean error over a cycle
    std::optional<double> v_bias_percent;  ///< cycles whose speed was measured, where the other > 0.05 m/s
    std::optional<double> v_sd_percent;    ///< the same
    std::optional<double> t_measured_percent;    ///< share of the finished cycles whose speed was measured
    std::optional<double> end_position_percent;  ///< of path_m
    std::optional<double> heading_end_deg;       ///< > 0: the flow odometry ends too far to the left
};

/// `track` must be finished.
Errors compare(const std::vector<FieldRow>& rows, const PoseTrack& track);

/// A figure of Errors with the words that explain it.
struct Figure {
    const char* name;
    const char* unit;
    const char* meaning;
    std::optional<double> Errors::*value;
};

/// Every figure, in the order of the outputs.
const std::array<Figure, 8>& error_figures();

}  // namespace flownav::evaluation
