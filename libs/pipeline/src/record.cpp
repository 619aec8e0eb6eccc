#include "record.h"

#include <cmath>

namespace flownav::pipeline {
namespace {

void count_label(BlockCounts& counts, BlockLabel label) {
    counts.ground += label == BlockLabel::Ground;
    counts.obstacle += label == BlockLabel::Obstacle;
    counts.eliminated += label == BlockLabel::Eliminated;
    counts.unsupported += label == BlockLabel::Unsupported;
    counts.moving += label == BlockLabel::Moving;
}

BlockLabel label_before_classification(bool fresh, bool valid) {
    if (fresh) return BlockLabel::Unjudged;
    return valid ? BlockLabel::Sifted : BlockLabel::Unplaced;
}

void clear_results(Step& step) {
    step.restarted = step.end_of_cycle = step.v_measured = step.new_contacts = false;
    step.image_of_cycle = 0;
    step.omega_radps = step.pitch_rate_radps = step.v_mps = 0.0;
    step.motion = EgoMotion{};
    step.counts = BlockCounts{};
    step.obstacles.clear();
    step.ground.clear();
    for (BlockRecord& block : step.blocks) block.fresh = false;
}

}  // namespace

void record_field(Step& step, const Field& field, FieldFault fault, const std::optional<double>& before_s) {
    clear_results(step);
    step.fault = fault;
    ++step.faults[static_cast<std::size_t>(fault)];
    const bool usable = fault != FieldFault::TimeNotRising || std::isfinite(field.timestamp_s);
    step.timestamp_s = usable ? field.timestamp_s : before_s.value_or(0.0);
}

void record_layout(Step& step, std::size_t blocks, const VirtualScan& scan) {
    step.blocks.assign(blocks, {});
    step.scan = scan;
}

void record_start(Step& step, bool restarted) {
    step.restarted = restarted;
    step.status = FieldStatus::Waiting;
}

void record_pitch(Step& step, double correction_rad) {
    step.pitch_correction_rad = correction_rad;
}

void record_vectors(Step& step, const FieldVectors& v) {
    const PlaneGeometry plane(v.reference);
    step.image_of_cycle = v.image_of_cycle;
    step.counts.placed = v.measured.placed;
    step.counts.confident = static_cast<int>(v.measured.samples.size());
    const bool first_of_cycle = v.image_of_cycle == 1;
    for (std::size_t i = 0; i < v.layout.size(); ++i) {
        BlockRecord& block = step.blocks[i];
        const FlowVector& vector = v.measured.vectors[i];
        block.in_ground_window = v.layout.in_ground_window[i] != 0;
        block.predicted_px = v.measured.predicted_px[i];
        block.fresh = v.is_credible && is_confident(vector, v.params);
        if (!block.fresh && !first_of_cycle && block.image_of_cycle > 0) continue;
        block.vector = vector;
        block.ray = block.fresh ? v.measured.rays[i] : RayFlow{};
        block.label = label_before_classification(block.fresh, vector.valid);
        block.image_of_cycle = block.fresh ? v.image_of_cycle : 0;
        block.omega_rad = block.fresh ? motion::omega_of(block.ray, plane, {1.0, 0.0}) : 0.0;
    }
    step.counts.inliers = v.measured.estimate.motion.inliers;
    step.counts.ground_window = v.measured.estimate.motion.ground_window;
}

void record_motion(Step& step, const AcceptedMotion& accepted, const IntegratedMotion& integrated,
                   const CyclePlan& plan) {
    step.status = accepted.status;
    step.motion = accepted.motion;
    step.T_start_robot = integrated.T_start_robot;
    step.omega_radps = integrated.omega_radps;
    step.v_mps = integrated.v_mps;
    step.pitch_rate_radps = integrated.pitch_rate_radps;
    step.cycle_images = plan.images;
    step.end_of_cycle = plan.ends;
    step.v_measured = accepted.motion.forward_measured && plan.ends;
}

void record_labels(Step& step, const BlockClasses& classes) {
    for (std::size_t i = 0; i < step.blocks.size(); ++i) {
        step.blocks[i].label = classes.of_block[i].label;
        step.blocks[i].excess_px = classes.of_block[i].excess_px;
        count_label(step.counts, classes.of_block[i].label);
    }
}

void record_surroundings(Step& step, const Reconstruction& surroundings) {
    step.obstacles = surroundings.obstacles;
    step.ground = surroundings.ground;
    step.scan = surroundings.scan;
}

void record_contacts(Step& step, const ContactScan& contacts, bool is_new) {
    step.contacts = contacts;
    step.new_contacts = is_new;
}

void record_carried_motion(Step& step, const CarriedMotion& motion, const Pose2& T_start_robot) {
    step.status = FieldStatus::BadField;
    step.motion = motion.told;
    step.omega_radps = motion.omega_radps;
    step.v_mps = motion.v_mps;
    step.T_start_robot = T_start_robot;
}

void record_pose(Step& step, const Pose2& T_start_robot) {
    step.T_start_robot = T_start_robot;
}

void record_reliability(Step& step, const CarriedPose& carried, const Eigen::Matrix3d& covariance,
                        const SensorChecks& others) {
    step.carried = carried;
    step.covariance = covariance;
    step.other_sensors = others;
}

}  // namespace flownav::pipeline
