#pragma once
#include <limits>

#include "flownav/core/flow_vector.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/motion/params.h"

namespace flownav::motion {

/// A measured vector on the normalised plane: its ends are mapped by the cameras of their own fields, which
/// takes care of field parity, lens distortion and roll.
RayFlow ray_flow(const FlowVector& vector, const RayMapper& reference, const RayMapper& newer,
                 Geometry geometry);

/// The same of a vector whose begin is known to lie at `begin` on the reference's plane.
RayFlow ray_flow(const FlowVector& vector, const Eigen::Vector2d& begin, const RayMapper& reference,
                 const RayMapper& newer, Geometry geometry);

/// What is known about a motion beforehand: rates times the time from the reference to the newer field.
struct MotionPrediction {
    double omega_rad = 0.0;
    double pitch_rad = 0.0;
    double forward_m = 0.0;
    double chord_rad = 0.0;  ///< see EgoMotion
    /// How far the true turn can be from omega_rad when nothing unforeseen happens; infinite: anywhere.
    double omega_tolerance_rad = std::numeric_limits<double>::infinity();
};

/// Eq. (3) for points of the ground, evaluated at the mid-point of the vector itself.
class GroundFlow {
  public:
    GroundFlow(const CameraMount& mount, const MotionPrediction& motion)
        : plane_(mount),
          travel_(camera_travel(mount, motion.forward_m, motion.omega_rad, motion.chord_rad)),
          omega_rad_(motion.omega_rad),
          pitch_rad_(motion.pitch_rad) {}

    /// `at`: in the reference.
    Eigen::Vector2d operator()(const Eigen::Vector2d& at) const {
        Eigen::Vector2d flow = Eigen::Vector2d::Zero();
        for (int i = 0; i < 3; ++i) {  // the mid-point depends on the vector: three rounds settle it
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
