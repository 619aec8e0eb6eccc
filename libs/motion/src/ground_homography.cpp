#include "ground_homography.h"

#include <Eigen/Geometry>
#include <cmath>

namespace flownav::motion {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// R_robot_camera: rotates rays of the level camera of pitch rho into robot axes (forward, left, up).
Matrix3d robot_axes(double pitch_rad) {
    const double a = std::cos(pitch_rad);
    const double b = std::sin(pitch_rad);
    Matrix3d C;
    C << 0, -b, a,  //
        -1, 0, 0,   //
        0, -a, -b;
    return C;
}

/// Homography of a camera whose true angles are those of the mount.
Matrix3d true_homography(const CameraMount& mount, const PairMotion& m) {
    const Matrix3d C = robot_axes(mount.pitch_rad);
    const Matrix3d turn = AngleAxisd(-m.omega_rad(), Vector3d::UnitZ()).toRotationMatrix();
    const Vector3d offset = Vector3d(mount.forward_m, mount.left_m, 0.0) / mount.height_m;
    const double heading = m.omega_rad() / 2 + m.chord_rad;
    const Vector3d chord = m.heights() * Vector3d(std::cos(heading), std::sin(heading), 0.0);
    const Vector3d shift = turn * (offset - chord) - offset;
    // -C.row(2) is the ground's normal; its product with a ray is the ratio of height to depth.
    const Matrix3d level = C.transpose() * (turn * C - shift * C.row(2));
    const AngleAxisd pitch(-m.pitch_rad(), Vector3d::UnitX());
    const AngleAxisd roll(m.roll_rad(), Vector3d::UnitZ());
    return pitch * roll.toRotationMatrix() * level;
}

}  // namespace

Matrix3d ground_homography(const CameraMount& mount, const MountAngles& error, const PairMotion& motion) {
    const CameraMount truth = corrected(mount, error);
    const Matrix3d R_true_assumed = level_rotation(truth) * level_rotation(mount).transpose();
    return R_true_assumed.transpose() * true_homography(truth, motion) * R_true_assumed;
}

}  // namespace flownav::motion
