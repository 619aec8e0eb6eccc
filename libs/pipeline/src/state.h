#pragma once
#include <optional>

#include "block_classes.h"
#include "carried_error.h"
#include "cycle_plan.h"
#include "flownav/flow/matcher.h"
#include "flownav/obstacles/contact_scanner.h"
#include "flownav/pipeline/motion_history.h"
#include "flownav/pipeline/pipeline.h"
#include "measure.h"
#include "other_sensors.h"
#include "pitch_online.h"
#include "pose_uncertainty.h"
#include "reconstruct.h"
#include "short_blocks.h"

namespace flownav::pipeline {

/// The memory of the pipeline, and the order of its stages.
class State::Impl {
  public:
    Impl(const Params& params, flow::Matcher matcher)
        : params_(params), matcher_(std::move(matcher)), others_(params.other_sensors) {}

    const Step& take(const Field& field);
    template <typename Reading>
    void note(const Reading& reading) {
        others_.note(reading);
    }
    std::optional<MotionBetween> motion_between(double from_s, double to_s) const;
    const Step& last_step() const { return step_; }

  private:
    // Fields that can be used.
    void follow(const Field& field, double since_field_s);
    void restart(bool new_camera, double since_field_s);
    void compare(double since_last_s);
    void scan_contacts(const EgoMotion& motion);
    void continue_scan();
    void advance(const AcceptedMotion& accepted, const IntegratedMotion& integrated, const CyclePlan& plan);
    void end_cycle(const EgoMotion& motion);
    void begin_cycle();
    // Other fields.
    void carry_over_field(double since_field_s);
    void note_pose(double since_field_s);
    void bridge_gap(double gap_s);

    void new_layout();
    void aim_layouts();
    void correct_pitch(ReferenceImage& image) const;
    double last_picture_s() const;

    Params params_;
    flow::Matcher matcher_;

    // The reference is frozen for a cycle; the newest field is compared with it and becomes the next one. The
    // third field of [P] 4.3 is the one that the caller is filling.
    ReferenceImage reference_;
    ReferenceImage newest_;
    bool has_reference_ = false;
    std::optional<double> newest_s_;  ///< time stamp of the newest field whose time was right
    CameraModel camera_;              ///< of the layout, as it came with its field
    PitchOnline pitch_;

    flow::BlockLayout layout_;
    flow::BlockLayout coarse_layout_;  ///< every few blocks of layout_, for searches
    Rates rates_;
    Odometry odometry_;
    Pose2 T_start_robot_;
    CycleQuality quality_;
    Cycle cycle_;

    Measurement measured_;  ///< of the newest field
    Measurement trial_;     ///< of a hypothesis
    BlockClasses classes_;
    Reconstruction surroundings_;
    obstacles::ContactMemory contact_memory_;
    ContactScan contacts_;     ///< of the last scan
    Pose2 T_start_scan_;       ///< of contacts_
    Pose2 T_start_next_scan_;  ///< of the scan under way
    ShortBlocks short_blocks_;
    double pitch_sum_rad_ = 0.0;  ///< of all ended cycles
    OtherSensors others_;         ///< wheels and gyro
    CarriedError carried_error_;
    PoseUncertainty uncertainty_;
    MotionHistory history_;
    double carried_s_ = 0.0;  ///< time carried over since the start
    bool bridged_ = false;    ///< other sensors told the whole motion over a gap
    Step step_;
};

}  // namespace flownav::pipeline
