#include "flownav/core/camera_model.h"

#include <Eigen/Geometry>
#include <cmath>

namespace flownav {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Brown-Conrady, as OpenCV defines it: ideal -> distorted normalised coordinates.
Vector2d distort(const Vector2d& p, const std::array<double, 5>& k) {
    const double r2 = p.squaredNorm();
    const double radial = 1.0 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]));
    const double xy2 = 2.0 * p.x() * p.y();
    return {p.x() * radial + k[2] * xy2 + k[3] * (r2 + 2.0 * p.x() * p.x()),
            p.y() * radial + k[2] * (r2 + 2.0 * p.y() * p.y()) + k[3] * xy2};
}

/// Inverse of distort() by Newton steps with a numeric Jacobian; a table or a fixed point would either copy
/// the image grid or converge slowly on wide lenses.
Vector2d undistort(const Vector2d& distorted, const std::array<double, 5>& k) {
    constexpr double step = 1e-6;
    Vector2d p = distorted;
    for (int i = 0; i < 12; ++i) {
        const Vector2d residual = distort(p, k) - distorted;
        if (residual.squaredNorm() < 1e-22) break;
        Eigen::Matrix2d J;
        J.col(0) = (distort(p + Vector2d(step, 0), k) - distort(p - Vector2d(step, 0), k)) / (2 * step);
        J.col(1) = (distort(p + Vector2d(0, step), k) - distort(p - Vector2d(0, step), k)) / (2 * step);
        const double det = J.determinant();
        if (std::abs(det) < 1e-9) break;
        p -= Vector2d(J(1, 1) * residual.x() - J(0, 1) * residual.y(),
                      J(0, 0) * residual.y() - J(1, 0) * residual.x()) /
             det;
    }
    return p;
}

}  // namespace

RayMapper::RayMapper(const CameraModel& camera)
    : camera_(camera),
      R_level_camera_(level_rotation(camera.mount)),
      distorted_(camera.distortion != std::array<double, 5>{}),
      rotated_(camera.mount.roll_rad != 0.0 || camera.mount.yaw_rad != 0.0),
      plain_(!distorted_ && !rotated_) {}

Vector2d RayMapper::levelled(const Vector2d& mounted) const {
    const Vector2d p = distorted_ ? undistort(mounted, camera_.distortion) : mounted;
    return rotated_ ? Vector2d((R_level_camera_ * p.homogeneous()).hnormalized()) : p;
}

Vector2d RayMapper::mounted(const Vector2d& levelled) const {
    const Vector2d p =
        rotated_ ? Vector2d((R_level_camera_.transpose() * levelled.homogeneous()).hnormalized()) : levelled;
    return distorted_ ? distort(p, camera_.distortion) : p;
}

Eigen::Matrix3d level_rotation(const CameraMount& m) {
    using Eigen::AngleAxisd;
    const AngleAxisd pitch(m.pitch_rad, Vector3d::UnitX());
    const AngleAxisd yaw(m.yaw_rad, -Vector3d::UnitY());
    const AngleAxisd roll(m.roll_rad, Vector3d::UnitZ());
    // Level camera = pitch only; mounted camera = yaw about the vertical, then pitch, then roll about its
    // axis.
    return (pitch * yaw * pitch.inverse() * roll).toRotationMatrix();
}

bool same_geometry(const CameraModel& a, const CameraModel& b) {
    const auto near = [](double p, double q, double tolerance) { return std::abs(p - q) <= tolerance; };
    const CameraMount& m = a.mount;
    const CameraMount& n = b.mount;
    return a.width_px == b.width_px && a.height_px == b.height_px && near(a.fx_px, b.fx_px, 1e-6) &&
           near(a.fy_px, b.fy_px, 1e-6) && near(a.cx_px, b.cx_px, 1e-6) && near(a.cy_px, b.cy_px, 0.75) &&
           a.distortion == b.distortion && near(m.height_m, n.height_m, 1e-6) &&
           near(m.pitch_rad, n.pitch_rad, 1e-6) && near(m.roll_rad, n.roll_rad, 1e-6) &&
           near(m.yaw_rad, n.yaw_rad, 1e-6) && near(m.forward_m, n.forward_m, 1e-6) &&
           near(m.left_m, n.left_m, 1e-6);
}

}  // namespace flownav
