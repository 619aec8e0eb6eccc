#pragma once
#include <Eigen/Core>
#include <array>

namespace flownav {

/// Where the camera sits on the robot. The robot frame is MRPT's: x forward, y left, z up, its origin on the
/// ground below the axis the robot turns about.
struct CameraMount {
    double height_m = 0.9;   ///< H, over the ground; > 0
    double pitch_rad = 0.0;  ///< rho, > 0 looks down
    double roll_rad = 0.0;   ///< > 0 tilts the camera to its right (clockwise seen from behind)
    double yaw_rad = 0.0;    ///< > 0 looks to the left of straight ahead
    double forward_m = 0.0;  ///< ahead of the axis
    double left_m = 0.0;     ///< beside the axis
};

/// Intrinsics, Brown-Conrady distortion and mount of the camera that took ONE image. A field of an interlaced
/// frame has fy/2 and a cy that carries the half line of its parity, and needs no special case anywhere.
struct CameraModel {
    int width_px = 0;
    int height_px = 0;
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    std::array<double, 5> distortion{};  ///< k1 k2 p1 p2 k3, OpenCV's order
    CameraMount mount;
};

/// Normalised coordinates (x right, y DOWN) of a pixel in the LEVEL camera: undistorted, and with roll and
/// yaw of the mount rotated away, so that only the pitch rho is left. This is the only place where lens and
/// mounting angles enter the equations.
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

    /// Pixel that level normalised coordinates fall on; inverse of ray() inside the image.
    Eigen::Vector2d pixel(const Eigen::Vector2d& ray) const {
        const Eigen::Vector2d p = plain_ ? ray : mounted(ray);
        return {camera_.fx_px * p.x() + camera_.cx_px, camera_.fy_px * p.y() + camera_.cy_px};
    }

    const CameraModel& camera() const { return camera_; }

  private:
    /// Between what lens and mount make of normalised coordinates, and level ones.
    Eigen::Vector2d levelled(const Eigen::Vector2d& mounted) const;
    Eigen::Vector2d mounted(const Eigen::Vector2d& levelled) const;

    CameraModel camera_;
    Eigen::Matrix3d R_level_camera_ = Eigen::Matrix3d::Identity();
    bool distorted_ = false;
    bool rotated_ = false;
    bool plain_ = true;  ///< neither
};

/// Rotation from the mounted camera's axes to those of the level camera, which has the same pitch and neither
/// roll nor yaw.
Eigen::Matrix3d level_rotation(const CameraMount& mount);

/// True when two images can share a block layout: same size, optics and mount; cy may differ by the half line
/// of a field's parity.
bool same_geometry(const CameraModel& a, const CameraModel& b);

}  // namespace flownav
