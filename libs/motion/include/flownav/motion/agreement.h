#pragma once
#include "flownav/core/sensor_agreement.h"
#include "flownav/math/ring.h"

namespace flownav::motion {

/// Limits of an agreement, in the unit of the compared quantity.
struct AgreementLimits {
    double amount_min = 0.0;  ///< motion within the window that is needed to tell an agreement
    double slack = 0.0;       ///< difference within the window that is always allowed
    double share = 0.25;      ///< allowed difference, of the motion within the window
};

/// Compares a quantity of another sensor, travel or turn, with the flow over the last seconds.
class Agreement {
  public:
    static constexpr double window_s = 3.0;

    /// One interval that both measured.
    struct Pair {
        double end_s = 0.0;
        double flow = 0.0;
        double other = 0.0;
        double sigma = 0.0;  ///< standard deviation of their difference
    };

    explicit Agreement(const AgreementLimits& limits) : limits_(limits) {}

    void note(const Pair& pair);

    /// Unchecked, Agrees or Contradicts. A contradiction ends when half of the limit is kept.
    SensorAgreement verdict() const { return verdict_; }

    /// What the sensor told over what the flow measured, within the window; 1 as long as too little moved.
    double ratio() const { return ratio_; }

  private:
    AgreementLimits limits_;
    Ring<Pair, 128> pairs_;
    SensorAgreement verdict_ = SensorAgreement::Unchecked;
    double ratio_ = 1.0;
};

}  // namespace flownav::motion
