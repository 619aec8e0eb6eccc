#pragma once
#include <Eigen/Core>
#include <array>
#include <limits>
#include <vector>

#include "flownav/core/camera_model.h"
#include "flownav/core/ego_motion.h"
#include "flownav/core/flow_vector.h"
#include "flownav/motion/params.h"

namespace flownav::motion {

/// Angles of a mount in rad, in the order pitch, roll, yaw.
using MountAngles = Eigen::Vector3d;

/// Returns the mount with `correction` added to its angles.
CameraMount corrected(CameraMount mount, const MountAngles& correction);

/// Normal equations of the correction of a camera's angles: information * correction = gradient. The
/// equations of several pairs of fields are added.
struct PoseEquations {
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< 1/rad^2
    MountAngles gradient = MountAngles::Zero();             ///< 1/rad
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();      ///< sum of gradient * gradient^T of the pairs
    /// Gradient of each of 8 strips of the floor, from far to near; the last two columns are the gradients of
    /// a systematic matching error in u and in v.
    Eigen::Matrix<double, 3, 10> strips = Eigen::Matrix<double, 3, 10>::Zero();
    int pairs = 0;

    PoseEquations& operator+=(const PoseEquations& other);
};

/// Standard deviation of the change of the camera's pitch and roll between the fields of a pair. The mean
/// change over a drive is zero; infinity means no prior.
struct PitchPrior {
    double pitch_rad = std::numeric_limits<double>::infinity();
    double roll_rad = std::numeric_limits<double>::infinity();
};

/// Fit of one pair of fields to a ground plane seen by a camera of the given mount.
struct PairFit {
    PoseEquations equations;  ///< pairs = 0: too few vectors of the near ground
    Eigen::Matrix3d H_newer_reference = Eigen::Matrix3d::Identity();  ///< maps level rays of the ground
    double noise_factor = 1.0;  ///< ratio of the residuals to the vectors' standard deviations
    double pitch_rad = 0.0;     ///< change from reference to newer field, > 0 raises the view
    double roll_rad = 0.0;      ///< change from reference to newer field, > 0 turns the image clockwise
    int near_vectors = 0;       ///< vectors where the near ground is expected
    int close_vectors = 0;      ///< near vectors within 3.5 standard deviations of the plane
    int ground_vectors = 0;     ///< near vectors with a weight in the fit
};

/// Smallest a y + b of the near ground. Farther parts of the image often show other objects than floor.
double near_below_horizon(const CameraModel& camera);

/// Working memory of fit_pair().
struct PoseScratch {
    std::vector<double> values;
};

/// Sets up the least squares equations of the camera's angles from one pair of fields. The pair's own turn,
/// pitch, roll and travel are unknowns as well and are eliminated. Vectors that do not move like the floor
/// get no weight (biweight). `motion` is the start of the iteration. The result has no pairs when there are
/// too few near vectors or the motion is not determined.
PairFit fit_pair(const std::vector<RayFlow>& rays, const CameraModel& camera, const EgoMotion& motion,
                 Geometry geometry, const PitchPrior& pitch_prior, PoseScratch& scratch);

/// Correction of the angles and its standard deviation. An angle that the pairs do not determine has a
/// correction near 0 and a deviation near `unknown_angle_rad`.
struct PoseCorrection {
    MountAngles correction_rad = MountAngles::Zero();
    MountAngles sigma_rad = MountAngles::Zero();
};

constexpr double unknown_angle_rad = 0.09;  ///< 5 degrees

PoseCorrection solve(const PoseEquations& equations);

/// Standard deviation of the angles in rad by systematic errors of matching or lens, which are equal in every
/// pair. Combines the disagreement of the floor's strips with an error of a few hundredths of a pixel that
/// grows from far to near. The equations must be those at the solution, where the correction is zero.
MountAngles systematic_sigma_rad(const PoseEquations& equations);

/// True for each of pitch, roll and yaw that is estimated; the others keep their values.
using AngleMask = std::array<bool, 3>;

/// Returns the equations of the unknown angles only.
PoseEquations select(const PoseEquations& equations, const AngleMask& unknown);

}  // namespace flownav::motion
