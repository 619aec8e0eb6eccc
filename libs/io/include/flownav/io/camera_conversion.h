#pragma once
#include <mrpt/img/TCamera.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/poses/CPose3D.h>

#include "flownav/config/config.h"
#include "flownav/core/camera_model.h"

namespace flownav::io {

/// Where a recorded camera pose (optical axes: x right, y down, z forward) puts the camera, angles included.
CameraMount camera_mount(const mrpt::poses::CPose3D& pose_robot_camera);

/// The inverse of camera_mount().
mrpt::poses::CPose3D camera_pose(const CameraMount& mount);

/// Intrinsics and plumb-bob distortion as MRPT stores them.
mrpt::img::TCamera camera_params(const CameraModel& camera);

/// The camera of an image of width_px x height_px that comes without any recorded calibration.
/// Throws ConfigError naming the missing keys, or a value out of its range.
CameraModel camera_model(const config::CameraConfig& config, int width_px, int height_px);

/// The camera that took a recorded image of width_px x height_px: the recording's calibration and pose, each
/// value replaced by the ini's where that has one. Woven frames: the camera of the whole frame.
/// Throws ConfigError: no calibration (names the keys), a lens model other than plumb bob, no optical pose,
/// height outside 0.01..20 m, pitch outside -5..80 deg, roll or yaw over 10 deg.
CameraModel camera_model(const mrpt::obs::CObservationImage& image, const config::CameraConfig& config,
                         int width_px, int height_px);

/// The camera of one field of a woven frame: line v is the frame's line 2 v (top) or 2 v + 1 (bottom).
CameraModel field_camera(const CameraModel& frame, bool bottom);

}  // namespace flownav::io
