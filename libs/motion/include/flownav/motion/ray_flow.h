#pragma once
#include <limits>

#include "flownav/core/flow_vector.h"
#include "flownav/core/plane_geometry.h"
#include "flownav/motion/params.h"

namespace flownav {

/// A measured vector on the normalised plane: its ends are mapped by the cameras of their own fields, which
/// takes care of field parity, lens distortion and roll.
RayFlow ray_flow(const FlowVector& vector, const RayMapper& reference, const RayMapper& newer,
                 Geometry geometry);

/// What is known about a motion beforehand: rates times the time from the reference to the newer field.
struct MotionPrediction {
    double omega_rad = 0.0;
    double pitch_rad = 0.0;
    double forward_m = 0.0;
    double chord_rad = 0.0;  ///< see EgoMotion
    /// How far the true turn can be from omega_rad when nothing unforeseen happens; infinite: anywhere.
    double omega_tolerance_rad = std::numeric_limits<double>::infinity();
};

/// Eq. (3) for a point of the ground at `at` in the reference, evaluated at the mid-point of the vector
/// itself.
Eigen::Vector2d predicted_ground_flow(const PlaneGeometry& plane, const CameraMount& mount,
                                      const Eigen::Vector2d& at, const MotionPrediction& motion);

}  // namespace flownav
