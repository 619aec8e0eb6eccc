#pragma once
#include <array>
#include <cstdint>

#include "flownav/core/field_status.h"
#include "flownav/core/pose2.h"
#include "flownav/pipeline/step.h"

namespace flownav::evaluation {

/// How many blocks have each label, in the order of BlockLabel.
using LabelCounts = std::array<std::uint16_t, 8>;

/// The little of a step that the metrics and the report still need after the drive.
struct FieldRow {
    double timestamp_s = 0.0;
    FieldStatus status = FieldStatus::Waiting;
    bool v_measured = false;
    bool starts_reference = false;  ///< the next fields are compared with this one
    double omega_radps = 0.0;
    double v_mps = 0.0;
    pipeline::CarriedPose carried;
    Pose2 T_start_robot;
    int placed = 0;
    int confident = 0;
    int inliers = 0;
    int ground_window = 0;
    int obstacles = 0;
    bool end_of_cycle = false;
    LabelCounts labels{};
};

/// Of the blocks that have a vector, or an ambiguous one, in the running cycle.
LabelCounts label_counts_of(const pipeline::Step& step);

FieldRow row_of(const pipeline::Step& step);

}  // namespace flownav::evaluation
