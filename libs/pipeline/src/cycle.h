#pragma once
#include <vector>

#include "flownav/core/derotation.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/pose2.h"
#include "flownav/obstacles/classify.h"

namespace flownav::pipeline {

/// Motion from the reference to one image of the cycle.
struct ImageOfCycle {
    EgoMotion motion;
    Derotation derotation;
    obstacles::ClassifierInput classifier;
    Pose2 T_reference_mid;  ///< half-way, where the vectors are evaluated
};

/// Images 1..j of the running cycle.
using Cycle = std::vector<ImageOfCycle>;

/// Rates that predict the next motion.
struct Rates {
    double omega_radps = 0.0;
    double v_mps = 0.0;
    double sigma_v_relative = 1.0;  ///< of v_mps; 1: unknown
    bool v_known = false;           ///< v_mps has been measured
    bool known = false;             ///< omega_radps has been measured
    double held_s = 0.0;            ///< time since omega_radps was measured
    double v_held_s = 0.0;          ///< time since v_mps was measured
    bool flow_lost = false;         ///< the flow did not measure the last turn, though it had measured one
    bool flow_lost_way = false;     ///< the same of the travel
};

/// Time from earlier fields to the newest one.
struct Elapsed {
    double last_s = 0.0;       ///< since the last field that was compared
    double reference_s = 0.0;  ///< since the reference
};

}  // namespace flownav::pipeline
