#include "carried_error.h"

#include <algorithm>
#include <cmath>

namespace flownav::pipeline {
namespace {

// A robot that stood when it was seen last may have begun to move.
constexpr double least_mps = 0.1;
constexpr double least_radps = 0.1;
constexpr double drift_per_s = 0.3;  // of speed and turn, relative, while they are carried over

}  // namespace

void CarriedError::Error::end_stretch() {
    before = sigma();
    stretch = 0.0;
}

double CarriedError::Error::sigma() const {
    return std::hypot(before, stretch);
}

void CarriedError::note(const Step& step, const KnownParts& known, double since_field_s, double carry_max_s) {
    const bool turn_measured = known.turn;
    const bool speed_measured = known.turn && known.way;
    since_s_ = speed_measured ? 0.0 : since_s_ + since_field_s;
    // The error of a carried speed grows; that of a robot which counts as standing is the whole speed.
    const double share = since_s_ > carry_max_s ? 1.0 : std::min(1.0, drift_per_s * since_s_);
    if (speed_measured) {
        v_mps_ = step.v_mps;
        position_m_.end_stretch();
    } else {
        position_m_.stretch += share * std::max(std::abs(v_mps_), least_mps) * since_field_s;
    }
    if (turn_measured) {
        omega_radps_ = step.omega_radps;
        heading_rad_.end_stretch();
    } else {
        heading_rad_.stretch += share * std::max(std::abs(omega_radps_), least_radps) * since_field_s;
    }
}

CarriedPose CarriedError::pose() const {
    return {since_s_, position_m_.sigma(), heading_rad_.sigma()};
}

}  // namespace flownav::pipeline
