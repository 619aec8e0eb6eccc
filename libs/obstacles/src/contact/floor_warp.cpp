#include "flownav/obstacles/floor_warp.h"

#include <Eigen/Geometry>

namespace flownav::obstacles {
namespace {

using Eigen::Matrix3d;
using Eigen::RowVector3d;
using Eigen::Vector3d;

Matrix3d intrinsics(const LevelCamera& c) {
    Matrix3d K = Matrix3d::Identity();
    K(0, 0) = c.fx_px;
    K(1, 1) = c.fy_px;
    K(0, 2) = c.cx_px;
    K(1, 2) = c.cy_px;
    return K;
}

/// From the camera's axes to level axes.
Matrix3d level_axes(const LevelCamera& c) {
    Matrix3d R = Matrix3d::Identity();
    R(1, 1) = R(2, 2) = c.a;
    R(1, 2) = c.b;
    R(2, 1) = -c.b;
    return R;
}

/// Half of the rotation of the scene, from the reference to the frame half-way.
Matrix3d half_rotation(const PairMotion& m) {
    const Vector3d half(-m.pitch_rad / 2, m.omega_rad / 2, m.roll_rad / 2);
    const double angle = half.norm();
    if (angle == 0.0) return Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, half / angle).toRotationMatrix();
}

}  // namespace

PairWarp pair_warp(const LevelCamera& reference, const LevelCamera& newer, const PairMotion& motion) {
    const Matrix3d back = half_rotation(motion).transpose();
    const Matrix3d to_pixels = intrinsics(reference) * level_axes(reference).transpose();
    const Matrix3d to_rays = level_axes(newer) * intrinsics(newer).inverse();
    const RowVector3d plane(motion.cross_slope, 1.0, motion.slope);
    PairWarp warp;
    warp.A = to_pixels * back * back * to_rays;
    warp.B = to_pixels * back * Vector3d(motion.right_m, 0.0, motion.forward_m);
    warp.floor = plane / newer.height_m * to_rays;
    warp.forward = to_rays.row(2);
    return warp;
}

}  // namespace flownav::obstacles
