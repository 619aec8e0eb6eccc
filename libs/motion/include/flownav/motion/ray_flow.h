#pragma once
#include <limits>

#include "flownav/core/flow_vector.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/motion/params.h"

namespace flownav::motion {

/// Maps a measured vector to the normalised plane. Each end is mapped by the camera of its own field, which
/// compensates field parity, lens distortion and roll.
RayFlow ray_flow(const FlowVector& vector, const RayMapper& reference, const RayMapper& newer,
                 Geometry geometry);

/// Overload for a vector whose begin is already mapped: `begin` lies on the reference's normalised plane.
RayFlow ray_flow(const FlowVector& vector, const Eigen::Vector2d& begin, const RayMapper& reference,
                 const RayMapper& newer, Geometry geometry);

/// Predicted motion from the reference to the newer field: rates times the time between them.
struct MotionPrediction {
    double omega_rad = 0.0;
    double pitch_rad = 0.0;
    double forward_m = 0.0;
    double chord_rad = 0.0;  ///< see EgoMotion
    /// Largest deviation of the true turn from omega_rad in regular motion; infinite: no limit.
    double omega_tolerance_rad = std::numeric_limits<double>::infinity();
};

/// Eq. (3) for points of the ground, evaluated at the mid-point of the resulting vector.
class GroundFlow {
  public:
    GroundFlow(const CameraMount& mount, const MotionPrediction& motion)
        : plane_(mount),
          travel_(camera_travel(mount, motion.forward_m, motion.omega_rad, motion.chord_rad)),
          omega_rad_(motion.omega_rad),
          pitch_rad_(motion.pitch_rad) {}

    /// Returns the flow of the ground point seen at `at` in the reference.
    Eigen::Vector2d operator()(const Eigen::Vector2d& at) const {
        Eigen::Vector2d flow = Eigen::Vector2d::Zero();
        for (int i = 0; i < 3; ++i) {  // fixed-point iteration: the mid-point depends on the vector
            const Eigen::Vector2d mid = at + flow / 2;
            // Eq. (3)
            flow = plane_.ground_inverse_depth(mid) * plane_.e(mid, travel_) + omega_rad_ * plane_.h(mid) +
                   pitch_rad_ * PlaneGeometry::p(mid);
        }
        return flow;
    }

  private:
    PlaneGeometry plane_;
    Eigen::Vector2d travel_;
    double omega_rad_, pitch_rad_;
};

}  // namespace flownav::motion
