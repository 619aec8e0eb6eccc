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
    /// Gradient by strip of the floor, from far to near; then what matching errors in u and v would make.
    Eigen::Matrix<double, 3, 10> strips = Eigen::Matrix<double, 3, 10>::Zero();
    int pairs = 0;

    PoseEquations& operator+=(const PoseEquations& other);
};

/// How calm the robot drives: deviation of the camera's pitch and roll from one field of a pair to the other.
/// What a drive gains in pitch it loses again, so the mean is zero; the calmer, the more a pair tells.
struct PitchPrior {
    double pitch_rad = std::numeric_limits<double>::infinity();
    double roll_rad = std::numeric_limits<double>::infinity();
};

/// How one pair of fields fits a ground plane seen by a camera of the given mount.
struct PairFit {
    PoseEquations equations;  ///< no pairs: too few vectors of the near ground
    Eigen::Matrix3d H_newer_reference = Eigen::Matrix3d::Identity();  ///< maps ground between level cameras
    double noise_factor = 1.0;  ///< how much larger the residuals are than the vectors' deviations
    double pitch_rad = 0.0;     ///< from one field to the other, > 0 raises the view
    double roll_rad = 0.0;      ///< > 0 turns the image clockwise
    int near_vectors = 0;       ///< where the near ground is expected
    int close_vectors = 0;      ///< of these: within a pixel or so
    int ground_vectors = 0;     ///< that agree
};

/// a y + b from which on the floor counts as near: what lies farther away is seldom nothing but floor.
double near_below_horizon(const CameraModel& camera);

/// Working memory of fit_pair().
struct PoseScratch {
    std::vector<double> values;
};

/// Least squares for the angles of the camera from one pair of fields, with the pair's own turn, pitch, roll
/// and travel eliminated: what is left is the pattern of the near floor's flow, above all the ratio of near
/// and far. Vectors that do not move like the floor lose their weight (biweight). `motion` is the start.
PairFit fit_pair(const std::vector<RayFlow>& rays, const CameraModel& camera, const EgoMotion& motion,
                 Geometry geometry, const PitchPrior& pitch_prior, PoseScratch& scratch);

/// Correction of the angles, and the standard deviation of each; an angle that the pairs do not determine
/// stays, with a deviation near `unknown_angle_rad`.
struct PoseCorrection {
    MountAngles correction_rad = MountAngles::Zero();
    MountAngles sigma_rad = MountAngles::Zero();
};

constexpr double unknown_angle_rad = 0.09;  ///< 5 degrees

PoseCorrection solve(const PoseEquations& equations);

/// Standard deviation that comes of vectors which are wrong alike in every pair, as the matching or the lens
/// makes them: from how strips of the floor, from near to far, contradict each other, and from an error of a
/// few hundredths of a pixel that grows from far to near. Needs equations at the solution, where the
/// correction is zero.
MountAngles systematic_sigma_rad(const PoseEquations& equations);

/// Which of pitch, roll and yaw are unknown; the others are taken as right.
using AngleMask = std::array<bool, 3>;

/// The equations of some of the angles.
PoseEquations select(const PoseEquations& equations, const AngleMask& unknown);

}  // namespace flownav::motion
