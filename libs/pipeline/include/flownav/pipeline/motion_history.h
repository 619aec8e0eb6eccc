#pragma once
#include <optional>

#include "flownav/core/ego_motion.h"
#include "flownav/core/pose2.h"
#include "flownav/math/ring.h"

namespace flownav::pipeline {

/// Motion of the robot between two times of the last seconds.
struct MotionBetween {
    Pose2 T_from_to;
    double sigma_m = 0.0;    ///< standard deviation of the position
    double sigma_rad = 0.0;  ///< standard deviation of the heading
    /// Flow: the odometry of the fields, which has every measured part; Wheels: the wheels alone; Prediction:
    /// a part of the motion was carried over.
    MotionSource source = MotionSource::Prediction;
};

/// The flow odometry of the last fields. Allocates no memory.
class MotionHistory {
  public:
    /// Odometry at a field. The variances are sums over all fields since the start.
    struct Entry {
        double timestamp_s = 0.0;
        Pose2 T_start_robot;
        double variance_m2 = 0.0;    ///< of the position: measured motion and motion carried over
        double variance_rad2 = 0.0;  ///< of the heading
        double carried_s = 0.0;      ///< time carried over since the start
    };

    void note(const Entry& entry) { entries_.push(entry); }

    /// The motion between two times, interpolated between fields; the second may be before the first. Empty
    /// when one of them is outside the fields that are remembered.
    std::optional<MotionBetween> between(double from_s, double to_s) const;

  private:
    std::optional<Entry> at(double time_s) const;

    Ring<Entry, 512> entries_;
};

}  // namespace flownav::pipeline
