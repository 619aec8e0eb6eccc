#pragma once
#include "flownav/pipeline/step.h"

namespace flownav::pipeline {

/// The parts of a field's motion that are measured or told.
struct KnownParts {
    bool turn = false;
    bool way = false;
};

/// Counts for how long the pose was carried over, and how wrong it may be by that.
class CarriedError {
  public:
    /// After every field that has a reference: `since_field_s` since the field before.
    void note(const Step& step, const KnownParts& known, double since_field_s, double carry_max_s);

    CarriedPose pose() const;

  private:
    /// Standard deviation of a sum of stretches: errors within one stretch add up, those of two are
    /// independent.
    struct Error {
        double before = 0.0;   ///< of all stretches that are over
        double stretch = 0.0;  ///< of the running one

        void end_stretch();
        double sigma() const;
    };

    double since_s_ = 0.0;
    double v_mps_ = 0.0;  ///< measured last
    double omega_radps_ = 0.0;
    Error position_m_;
    Error heading_rad_;
};

}  // namespace flownav::pipeline
