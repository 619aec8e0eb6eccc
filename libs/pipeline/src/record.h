#pragma once
#include <optional>

#include "block_classes.h"
#include "cycle_plan.h"
#include "flownav/core/field.h"
#include "flownav/pipeline/step.h"
#include "reconstruct.h"

// Fills the Step record; no other file of this module writes to it.
namespace flownav::pipeline {

/// Clears the results of the last field, and enters fault and time stamp of the new one. `before_s`: time
/// stamp of the field before, if there was one.
void record_field(Step& step, const Field& field, FieldFault fault, const std::optional<double>& before_s);

/// Enters the blocks and the empty scan of a new layout.
void record_layout(Step& step, std::size_t blocks, const VirtualScan& scan);

/// Enters the start of a new chain. `restarted`: there was one before.
void record_start(Step& step, bool restarted);

/// Enters the correction of the pitch that the field's camera has, radians.
void record_pitch(Step& step, double correction_rad);

/// The vectors of one field and the blocks they belong to.
struct FieldVectors {
    const Measurement& measured;
    const flow::BlockLayout& layout;
    const CameraMount& reference;
    const flow::FlowParams& params;
    bool is_credible = false;  ///< false: the motion is not known, and no vector is used
    int image_of_cycle = 0;    ///< 1..
};

/// Enters vectors and counts. A block without a good vector keeps its last one of the cycle.
void record_vectors(Step& step, const FieldVectors& vectors);

/// Enters motion, pose and the plan of the cycle.
void record_motion(Step& step, const AcceptedMotion& accepted, const IntegratedMotion& integrated,
                   const CyclePlan& plan);

/// Enters the class of every block.
void record_labels(Step& step, const BlockClasses& classes);

/// Enters obstacles, floor and scan at the end of a cycle.
void record_surroundings(Step& step, const Reconstruction& surroundings);

/// Enters the last contact scan at the end of a cycle. `is_new`: it was made in this field.
void record_contacts(Step& step, const ContactScan& contacts, bool is_new);

/// Enters a motion that was carried over a field that cannot be compared.
void record_carried_motion(Step& step, const CarriedMotion& motion, const Pose2& T_start_robot);

/// Enters the pose after a gap.
void record_pose(Step& step, const Pose2& T_start_robot);

/// Enters how far the pose can be relied on, and how other sensors agree with the flow.
void record_reliability(Step& step, const CarriedPose& carried, const Eigen::Matrix3d& covariance,
                        const SensorChecks& others);

}  // namespace flownav::pipeline
