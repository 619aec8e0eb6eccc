#pragma once
#include <Eigen/Core>
#include <vector>

#include "flownav/core/camera_model.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/flow_vector.h"
#include "flownav/motion/params.h"

namespace flownav {

/// Angles of a mount, in the order of the unknowns: pitch, roll, yaw; radians.
using MountAngles = Eigen::Vector3d;

/// The mount with its angles changed by `correction`.
CameraMount corrected(CameraMount mount, const MountAngles& correction);

/// Normal equations of the error of a camera's angles: information * correction = gradient. Those of several
/// pairs of fields add up.
struct PoseEquations {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< 1/rad^2
    MountAngles gradient = MountAngles::Zero();             ///< 1/rad
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();      ///< sum of gradient * gradient^T of the pairs
    int pairs = 0;

    PoseEquations& operator+=(const PoseEquations& other);
};

/// How one pair of fields fits a ground plane seen by a camera of the given mount.
struct PairFit {
    PoseEquations equations;  ///< no pairs: too few vectors of the near ground
    Eigen::Matrix3d H_newer_reference = Eigen::Matrix3d::Identity();  ///< maps ground between level cameras
    double noise_factor = 1.0;  ///< how much larger the residuals are than the vectors' deviations
    int ground_vectors = 0;     ///< that agree
};

/// Working memory of fit_pair().
struct PoseScratch {
    std::vector<double> values;
};

/// Least squares for the angles of the camera from one pair of fields, with the pair's own turn, pitch, roll
/// and travel eliminated: what is left is the pattern of the near floor's flow, above all the ratio of near
/// and far. Vectors that do not move like the floor lose their weight (biweight). `motion` is the start.
PairFit fit_pair(const std::vector<RayFlow>& rays, const CameraModel& camera, const EgoMotion& motion,
                 Geometry geometry, PoseScratch& scratch);

/// Correction of the angles, and the standard deviation of each; an angle that the pairs do not determine
/// stays, with a deviation near `unknown_angle_rad`.
struct PoseCorrection {
    MountAngles correction_rad = MountAngles::Zero();
    MountAngles sigma_rad = MountAngles::Zero();
};

constexpr double unknown_angle_rad = 0.09;  ///< 5 degrees

PoseCorrection solve(const PoseEquations& equations);

/// Correction of the pitch alone, the other angles taken as right.
PoseCorrection solve_pitch(const PoseEquations& equations);

}  // namespace flownav
