#pragma once
#include "flownav/config/config.h"
#include "flownav/core/camera_model.h"
#include "grey_image.h"

namespace flownav::io {

/// The image as the sensor uses it: mirrored, turned and cut off as the ini says. Shares the pixels unless it
/// is mirrored or turned.
GreyImage turned(const GreyImage& image, const config::CameraConfig& config);

/// The camera of the turned image. The angles and the place of the mount stay as they are. Throws ConfigError
/// when the masked rows reach neither the top nor the bottom of the image, or leave too little of it, or a
/// woven frame is to be turned.
CameraModel turned(const CameraModel& camera, const config::CameraConfig& config);

}  // namespace flownav::io
