#pragma once
#include <Eigen/Core>

#include "flownav/core/lens.h"

namespace flownav {

/// Pose of the camera on the robot. Robot frame as in MRPT: x forward, y left, z up, origin on the ground
/// below the axis the robot turns about.
struct CameraMount {
    double height_m = 0.9;   ///< H, over the ground; > 0
    double pitch_rad = 0.0;  ///< rho, > 0 looks down
    double roll_rad = 0.0;   ///< > 0 tilts the camera to its right (clockwise seen from behind)
    double yaw_rad = 0.0;    ///< > 0 looks to the left of straight ahead
    double forward_m = 0.0;  ///< distance ahead of the axis
    double left_m = 0.0;     ///< distance to the left of the axis
};

/// Intrinsics, lens and mount of the camera that took ONE image. A field of an interlaced frame has fy/2 and
/// a cy that carries the half line of its parity.
struct CameraModel {
    int width_px = 0;
    int height_px = 0;
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    LensCoefficients distortion{};  ///< of `lens`; all 0 for an ideal Brown-Conrady lens
    CameraMount mount;
    const Lens* lens = &brown_conrady();  ///< not null; outlives the images
};

/// True when the lens shows every point where a pinhole camera shows it.
bool has_ideal_lens(const CameraModel& camera);

/// Normalised coordinates (x right, y DOWN) of a pixel in the LEVEL camera: undistorted, and with roll and
/// yaw of the mount rotated away, so that only the pitch rho is left. Lens and mounting angles enter the
/// equations here only.
class RayMapper {
  public:
    RayMapper() = default;
    explicit RayMapper(const CameraModel& camera);

    /// Level normalised coordinates of pixel (u, v).
    Eigen::Vector2d ray(const Eigen::Vector2d& pixel_px) const {
        const Eigen::Vector2d p((pixel_px.x() - camera_.cx_px) / camera_.fx_px,
                                (pixel_px.y() - camera_.cy_px) / camera_.fy_px);
        return plain_ ? p : levelled(p);
    }

    /// Pixel (u, v) of level normalised coordinates; inverse of ray() inside the image.
    Eigen::Vector2d pixel(const Eigen::Vector2d& ray) const {
        const Eigen::Vector2d p = plain_ ? ray : mounted(ray);
        return {camera_.fx_px * p.x() + camera_.cx_px, camera_.fy_px * p.y() + camera_.cy_px};
    }

    const CameraModel& camera() const { return camera_; }

  private:
    /// Level normalised coordinates of those behind lens and mount, and the inverse.
    Eigen::Vector2d levelled(const Eigen::Vector2d& mounted) const;
    Eigen::Vector2d mounted(const Eigen::Vector2d& levelled) const;

    CameraModel camera_;
    Eigen::Matrix3d R_level_camera_ = Eigen::Matrix3d::Identity();
    bool distorted_ = false;
    bool rotated_ = false;
    bool plain_ = true;  ///< neither distorted_ nor rotated_
};

/// R_level_camera: rotates from the mounted camera's axes to those of the level camera, which has the same
/// pitch but no roll and no yaw.
Eigen::Matrix3d level_rotation(const CameraMount& mount);

/// True when two images can share a block layout: same size, lens, optics and mount; cy may differ by the
/// half line of a field's parity.
bool same_geometry(const CameraModel& a, const CameraModel& b);

}  // namespace flownav
