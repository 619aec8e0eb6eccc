#pragma once
#include <array>
#include <cstdint>

#include "flownav/core/field_status.h"
#include "flownav/core/pose2.h"
#include "flownav/core/strip_counts.h"
#include "flownav/pipeline/step.h"

namespace flownav::evaluation {

/// Number of blocks with each label, in the order of BlockLabel.
using LabelCounts = std::array<std::uint16_t, 8>;

/// Summary of a contact scan.
struct ContactRow {
    bool is_new = false;  ///< a scan came with this field; else all other values are empty
    ContactGate gate = ContactGate::Off;
    StripCounts strips;
    double fit_share = 0.0;
    double vignetting = 0.0;

    /// True when a new scan has strips.
    bool is_scanned() const { return is_new && gate == ContactGate::Open; }
};

/// The values of a step that metrics and report need after the drive.
struct FieldRow {
    double timestamp_s = 0.0;
    FieldStatus status = FieldStatus::Waiting;
    bool v_measured = false;
    bool starts_reference = false;  ///< this field is the reference of the next ones
    double omega_radps = 0.0;
    double v_mps = 0.0;
    double pitch_rate_radps = 0.0;
    MotionSource omega_source = MotionSource::Prediction;
    MotionSource forward_source = MotionSource::Prediction;
    SensorChecks other_sensors;
    pipeline::CarriedPose carried;
    Pose2 T_start_robot;
    int placed = 0;
    int confident = 0;
    int inliers = 0;
    int ground_window = 0;
    int obstacles = 0;
    bool end_of_cycle = false;
    LabelCounts labels{};
    ContactRow contacts;
};

/// Counts the labels of all blocks of a step.
LabelCounts label_counts_of(const pipeline::Step& step);

ContactRow contact_row_of(const pipeline::Step& step);

FieldRow row_of(const pipeline::Step& step);

}  // namespace flownav::evaluation
