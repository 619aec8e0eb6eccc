#pragma once
#include <optional>

#include "flownav/core/readings.h"
#include "flownav/math/ring.h"

namespace flownav::motion {

/// Motion between two times as the wheels tell it.
struct WheelMotion {
    Pose2 T_from_to;
    double sigma_forward_m = 0.0;  ///< standard error of the way
    double sigma_turn_rad = 0.0;   ///< standard error of the turn
};

/// The wheel readings of the last seconds. Allocates no memory.
class WheelTrack {
  public:
    static constexpr double extrapolation_s = 0.1;  ///< how far a time may lie outside the readings
    static constexpr double pause_max_s = 0.6;      ///< longest pause of the readings that is interpolated

    /// Takes a reading. One that is not finite, or not later than the last, is left out. After a jump that no
    /// robot can make, the readings before it are forgotten.
    void note(const WheelPose& reading);

    /// The motion between two times, interpolated between readings. Empty when the readings do not reach from
    /// one to the other, when they pause between them, or when `to_s` is before `from_s`.
    std::optional<WheelMotion> between(double from_s, double to_s) const;

    bool empty() const { return readings_.empty(); }
    double newest_s() const { return readings_.back().timestamp_s; }  ///< of a track that is not empty

  private:
    struct Interpolated {
        Pose2 T_odom_robot;
        double outside_s = 0.0;  ///< time outside the readings
    };

    std::optional<Interpolated> at(double time_s) const;
    bool pauses_between(double from_s, double to_s) const;

    Ring<WheelPose, 1024> readings_;
};

/// Signed length of the chord of a motion, > 0 forward.
double chord_m(const Pose2& T_from_to);

}  // namespace flownav::motion
