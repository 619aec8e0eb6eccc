#pragma once

#include <Eigen/Core>
#include <array>

#include "flownav/sim/world.h"

namespace flownav::sim {

/// A ray origin + t * direction in the world frame. The direction advances by 1 along the optical axis of the
/// level camera, so t is the depth.
struct Ray {
    Eigen::Vector3d origin_m;
    Eigen::Vector3d direction;
};

/// The bare floor's surface: the plane z = 0, or a sum of waves.
class Floor {
  public:
    explicit Floor(const FloorWaves& waves);

    double height_m(const Eigen::Vector2d& at_m) const;

    /// t where a ray that leads downwards from above meets the floor: the last of the bumps that it grazes.
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

}  // namespace flownav::sim
