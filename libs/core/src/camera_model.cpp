#include "flownav/core/camera_model.h"

#include <Eigen/Geometry>
#include <cmath>

namespace flownav {

using Eigen::Vector2d;
using Eigen::Vector3d;

bool has_ideal_lens(const CameraModel& camera) {
    return camera.lens->is_ideal(camera.distortion);
}

RayMapper::RayMapper(const CameraModel& camera)
    : camera_(camera),
      R_level_camera_(level_rotation(camera.mount)),
      distorted_(!has_ideal_lens(camera)),
      rotated_(camera.mount.roll_rad != 0.0 || camera.mount.yaw_rad != 0.0),
      plain_(!distorted_ && !rotated_) {}

Vector2d RayMapper::levelled(const Vector2d& mounted) const {
    const Vector2d p = distorted_ ? camera_.lens->undistort(mounted, camera_.distortion) : mounted;
    return rotated_ ? Vector2d((R_level_camera_ * p.homogeneous()).hnormalized()) : p;
}

Vector2d RayMapper::mounted(const Vector2d& levelled) const {
    const Vector2d p =
        rotated_ ? Vector2d((R_level_camera_.transpose() * levelled.homogeneous()).hnormalized()) : levelled;
    return distorted_ ? camera_.lens->distort(p, camera_.distortion) : p;
}

Eigen::Matrix3d level_rotation(const CameraMount& m) {
    using Eigen::AngleAxisd;
    const AngleAxisd pitch(m.pitch_rad, Vector3d::UnitX());
    const AngleAxisd yaw(m.yaw_rad, -Vector3d::UnitY());
    const AngleAxisd roll(m.roll_rad, Vector3d::UnitZ());
    // The level camera has the pitch only. The mounted camera has the yaw about the vertical, then the pitch,
    // then the roll about its optical axis.
    return (pitch * yaw * pitch.inverse() * roll).toRotationMatrix();
}

bool same_geometry(const CameraModel& a, const CameraModel& b) {
    const auto near = [](double p, double q, double tolerance) { return std::abs(p - q) <= tolerance; };
    const CameraMount& m = a.mount;
    const CameraMount& n = b.mount;
    return a.width_px == b.width_px && a.height_px == b.height_px && near(a.fx_px, b.fx_px, 1e-6) &&
           near(a.fy_px, b.fy_px, 1e-6) && near(a.cx_px, b.cx_px, 1e-6) && near(a.cy_px, b.cy_px, 0.75) &&
           a.lens == b.lens && a.distortion == b.distortion && near(m.height_m, n.height_m, 1e-6) &&
           near(m.pitch_rad, n.pitch_rad, 1e-6) && near(m.roll_rad, n.roll_rad, 1e-6) &&
           near(m.yaw_rad, n.yaw_rad, 1e-6) && near(m.forward_m, n.forward_m, 1e-6) &&
           near(m.left_m, n.left_m, 1e-6);
}

}  // namespace flownav
