#pragma once
#include <optional>
#include <vector>

#include "carried_error.h"
#include "flownav/flow/block_layout.h"
#include "flownav/obstacles/dynamic_objects.h"
#include "flownav/pipeline/pipeline.h"
#include "measure.h"
#include "pitch_online.h"

namespace flownav::pipeline {

/// Motion from the reference to one image of the cycle.
struct ImageOfCycle {
    EgoMotion motion;
    Derotation derotation;
    obstacles::ClassifierInput judged;
    Pose2 T_reference_mid;  ///< half-way, where the vectors are evaluated
};

/// Rates that predict the next motion.
struct Rates {
    double omega_radps = 0.0;
    double v_mps = 0.0;
    double sigma_v_relative = 1.0;  ///< of v_mps; 1: not known at all
    bool v_known = false;           ///< v_mps has been measured
    bool known = false;             ///< omega_radps has been measured
    double held_s = 0.0;            ///< for so long it was not
    double v_held_s = 0.0;          ///< for so long v_mps was not
};

struct State::Impl {
    Params params;
    flow::Matcher matcher;

    // The ring: the reference is frozen for a cycle, the newest is compared with it and follows it; the third
    // field of [P] 4.3 is the one that the caller is filling.
    ReferenceImage reference;
    ReferenceImage newest;
    bool has_reference = false;
    std::optional<double> newest_s;  ///< time stamp of the newest field whose time was right
    CameraModel camera;              ///< of the layout, as it came with its field
    PitchOnline pitch;

    flow::BlockLayout layout;
    flow::BlockLayout coarse_layout;  ///< every few blocks of it, for the search without prediction
    Rates rates;
    Pose2 T_start_reference;
    struct {
        EgoMotion motion;
        double timestamp_s = 0.0;
    } last_measured;                  ///< of this cycle; the reference when nothing else
    EgoMotion counted;                ///< since the reference, as T_start_robot has it
    int first_inliers = 0;            ///< of the cycle's first image
    int failures = 0;                 ///< images in a row that could not be compared
    std::vector<ImageOfCycle> cycle;  ///< images 1..j of the running cycle

    Measurement measured;  ///< of the newest field
    Measurement trial;     ///< of a hypothesis
    std::vector<obstacles::Classification> judgements;
    obstacles::DynamicRegions movers;  ///< among the blocks of the running cycle
    std::vector<char> moved_before;    ///< 1: the block belonged to a mover at the end of the last cycle
    CarriedError carried_error;
    Step step;
};

}  // namespace flownav::pipeline
