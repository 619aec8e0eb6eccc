#pragma once
#include <mrpt/img/TCamera.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/poses/CPose3D.h>

#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/camera_model.h"

namespace flownav::io {

/// Converts a recorded camera pose (optical axes: x right, y down, z forward) to position and angles of the
/// mount.
CameraMount camera_mount(const mrpt::poses::CPose3D& pose_robot_camera);

/// The inverse of camera_mount().
mrpt::poses::CPose3D camera_pose(const CameraMount& mount);

/// Intrinsics and plumb-bob distortion as MRPT stores them. Throws std::invalid_argument: another lens than
/// Brown-Conrady.
mrpt::img::TCamera camera_params(const CameraModel& camera);

/// Camera of an image of width_px x height_px without recorded calibration. Throws ConfigError naming the
/// missing keys, or a value out of its range.
CameraModel camera_model(const config::CameraConfig& config, int width_px, int height_px);

/// Camera of a recorded image, and what was put right or looks odd about its calibration.
struct CameraReading {
    CameraModel camera;
    /// pose_x_forward: the pose has axes x forward, z up instead of the optical ones, and was converted;
    /// calibration_scaled: the intrinsics were of another image size of the same shape, and were converted;
    /// calibration_of_another_size: the recorded size is another, but the intrinsics fit this image;
    /// principal_point_off_centre: it is more than 22 % of the size from the middle of the image.
    std::vector<std::string> notes;
};

/// Camera of a recorded image of width_px x height_px, before it is turned as `config` says: the recorded
/// calibration and pose, overridden by the values that the ini sets, for the turned image. For woven frames
/// it is the camera of the whole frame. Throws ConfigError: no calibration (names the keys), a calibration
/// for an image of another shape, intrinsics that are no pixels, a lens model other than plumb bob, no
/// optical pose, height outside 0.01..20 m, pitch outside -5..80 deg, roll or yaw over 10 deg.
CameraReading read_camera(const mrpt::obs::CObservationImage& image, const config::CameraConfig& config,
                          int width_px, int height_px);

/// Camera of one field of a woven frame: line v of the field is line 2 v (top) or 2 v + 1 (bottom) of the
/// frame.
CameraModel field_camera(const CameraModel& frame, bool bottom);

}  // namespace flownav::io
