#pragma once
#include <Eigen/Core>
#include <array>

#include "flownav/core/pose2.h"
#include "flownav/testing/world.h"

namespace flownav::testing {

/// A ray origin + t * direction in the world frame. The direction advances by 1 along the optical axis of the
/// level camera, so t is the depth.
struct Ray {
    Eigen::Vector3d origin_m;
    Eigen::Vector3d direction;
};

/// The ground's surface: the plane z = 0, or a sum of waves.
class Floor {
  public:
    explicit Floor(const FloorWaves& waves);

    double height_m(const Eigen::Vector2d& at_m) const;

    /// t where a ray that leads downwards from above meets the ground. Where it grazes bumps that may hide
    /// one another, it is the last one it meets.
    double meet(const Ray& ray) const;

  private:
    struct Wave {
        Eigen::Vector2d per_m = Eigen::Vector2d::Zero();  ///< phase per metre in x and y, radians
        double phase = 0.0;
        double amplitude_m = 0.0;
    };

    bool plane_ = true;
    std::array<Wave, 6> waves_;
};

/// How a robot on four sprung wheels stands on uneven ground.
struct Ride {
    double heave_m = 0.0;
    double pitch_rad = 0.0;  ///< > 0 looks down
};

Ride ride_over(const World& world, const Pose2& T_world_robot);

}  // namespace flownav::testing
