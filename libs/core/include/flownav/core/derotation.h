#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "flownav/core/flow_vector.h"
#include "flownav/core/plane_geometry.h"

namespace flownav {

/// Point at which e, h and the ground depth of a vector are evaluated.
enum class Geometry {
    MidPoint,  ///< half-way along the vector: exact for finite displacements
    Block,     ///< at the reference block, as printed in [P]: T and obstacles are biased
};

/// Removes a turn and a pitch from vectors: Eq. (9). Geometry::MidPoint is exact for turns of any size: both
/// ends of a vector are rotated into the orientation half-way, in which the robot's chord points straight
/// ahead; the remaining flow is that of pure travel and lies on a line through the FOE. Geometry::Block
/// subtracts omega h + pitch p at the reference block, as printed.
class Derotation {
  public:
    Derotation() = default;
    Derotation(const PlaneGeometry& plane, double omega_rad, double pitch_rad, Geometry geometry)
        : plane_(plane), omega_rad_(omega_rad), pitch_rad_(pitch_rad), geometry_(geometry) {
        // Half the turn in camera axes; a left turn is positive about the vertical that points up.
        const Eigen::Vector3d half(pitch_rad / 2, -omega_rad / 2 * plane.a, -omega_rad / 2 * plane.b);
        const double angle = half.norm();
        if (angle > 0.0) R_newer_mid_ = Eigen::AngleAxisd(-angle, half / angle).toRotationMatrix();
    }

    /// Returns d of Eq. (9) and the point where it is evaluated.
    RayFlow operator()(const RayFlow& ray) const {
        if (geometry_ == Geometry::Block) {
            return {ray.at, ray.flow - omega_rad_ * plane_.h(ray.at) - pitch_rad_ * PlaneGeometry::p(ray.at),
                    ray.sigma};
        }
        const Eigen::Vector3d begin = Eigen::Vector2d(ray.at - ray.flow / 2).homogeneous();
        const Eigen::Vector3d end = Eigen::Vector2d(ray.at + ray.flow / 2).homogeneous();
        const Eigen::Vector2d from = (R_newer_mid_ * begin).hnormalized();
        const Eigen::Vector2d to = (R_newer_mid_.transpose() * end).hnormalized();
        return {(from + to) / 2, to - from, ray.sigma};
    }

  private:
    PlaneGeometry plane_;
    double omega_rad_ = 0.0;
    double pitch_rad_ = 0.0;
    Geometry geometry_ = Geometry::MidPoint;
    Eigen::Matrix3d R_newer_mid_ = Eigen::Matrix3d::Identity();  ///< equal to R_mid_reference
};

}  // namespace flownav
