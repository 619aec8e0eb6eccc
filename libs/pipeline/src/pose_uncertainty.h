#pragma once
#include <Eigen/Core>

#include "flownav/core/ego_motion.h"
#include "flownav/pipeline/step.h"

namespace flownav::pipeline {

/// Covariance of the pose by the errors of the measured motion; motion that is carried over is not in it. The
/// errors of different cycles are independent, but for the scale of the travel, which is the same all along.
class PoseUncertainty {
  public:
    /// Takes the motion since the reference at T_start_reference. A part that is not measured counts as
    /// exact.
    void move(const Pose2& T_start_reference, const EgoMotion& motion);

    /// The pose of the last move() becomes the reference.
    void begin_cycle();

    /// Covariance of (x, y, yaw) in the start frame, with the error of what was carried over.
    Eigen::Matrix3d covariance(const Pose2& T_start_robot, const CarriedPose& carried) const;

    double way_variance_m2() const { return way_variance_m2_; }  ///< of the sum of all measured travel
    double turn_variance_rad2() const { return turn_variance_rad2_; }

  private:
    Eigen::Matrix3d reference_ = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d now_ = Eigen::Matrix3d::Zero();
    double reference_way_m2_ = 0.0, way_variance_m2_ = 0.0;
    double reference_turn_rad2_ = 0.0, turn_variance_rad2_ = 0.0;
};

}  // namespace flownav::pipeline
