#pragma once
#include <optional>

#include "flownav/core/readings.h"
#include "flownav/math/ring.h"

namespace flownav::motion {

/// Turn between two times as a gyro tells it, without the bias.
struct GyroTurn {
    double omega_rad = 0.0;
    double sigma_rad = 0.0;  ///< standard error
};

/// The gyro readings of the last seconds and the bias learnt from them. Allocates no memory.
class GyroTrack {
  public:
    static constexpr double extrapolation_s = 0.1;  ///< how far a time may lie outside the readings
    static constexpr double pause_max_s = 0.3;      ///< longest pause of the readings that is interpolated

    /// Takes a reading. One that is not finite, or not later than the last, is left out.
    void note(const GyroRate& reading);

    /// The turn between two times: the integral of the readings, linear between two of them, less the bias.
    /// Empty when the readings do not reach from one to the other, when they pause between them, or when
    /// `to_s` is before `from_s`.
    std::optional<GyroTurn> between(double from_s, double to_s) const;

    /// Learns the bias from a turn between two times that is known otherwise, with its standard error. A turn
    /// that the bias cannot explain is left out.
    void learn_bias(double from_s, double to_s, double omega_rad, double sigma_rad);

    double bias_radps() const { return bias_radps_; }
    bool empty() const { return nodes_.empty(); }
    double newest_s() const { return nodes_.back().timestamp_s; }  ///< of a track that is not empty

  private:
    struct Node {
        double timestamp_s = 0.0;
        double omega_radps = 0.0;
        double heading_rad = 0.0;  ///< integral of the readings since the first one
        double begun_s = 0.0;      ///< first reading after the last pause
    };

    /// Integral of the readings up to a time, and the rate then; outside the readings the rate goes on.
    struct Heading {
        double heading_rad = 0.0;
        double omega_radps = 0.0;
    };

    std::optional<Heading> at(double time_s) const;

    Ring<Node, 2048> nodes_;
    double bias_radps_ = 0.0;
    double bias_variance_ = 0.05 * 0.05;  ///< (rad/s)^2; of a gyro that nobody has calibrated
    double learnt_s_ = 0.0;               ///< time of the last lesson; 0: none
};

}  // namespace flownav::motion
