#pragma once

#include <cstdint>
#include <optional>

#include "flownav/core/pose2.h"
#include "flownav/sim/random.h"

namespace flownav::sim {

/// Errors of counted wheel turns. The noise is a random walk: it grows with the square root of the way and
/// does not depend on how often the wheels are read.
struct OdometryParams {
    double scale = 1.006;           ///< measured over true distance
    double turn_scale = 1.01;       ///< measured over true turn
    double way_noise_m = 0.001;     ///< sigma of the distance, after 1 m
    double turn_noise_rad = 0.002;  ///< sigma of the heading, after 1 m or after turning by 1 rad
    std::uint64_t seed = 1;
};

/// What the wheels of a robot believe. Starts at the first true pose, so that its frame is the world's until
/// it drifts.
class WheelOdometry {
  public:
    explicit WheelOdometry(const OdometryParams& params) : params_(params), random_(params.seed) {}

    /// Reads the wheels: T_odom_robot when the robot has come to `T_world_robot` along an arc since the last
    /// reading.
    Pose2 update(const Pose2& T_world_robot);

  private:
    OdometryParams params_;
    Random random_;
    std::optional<Pose2> T_world_robot_;
    Pose2 T_odom_robot_;
};

}  // namespace flownav::sim
