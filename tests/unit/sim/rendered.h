#pragma once

#include <opencv2/core/mat.hpp>

#include "flownav/sim/camera_simulator.h"
#include "flownav/testing/scene.h"

namespace flownav::sim {

/// A copy of the pixels.
cv::Mat1b picture_of(const Field& field);

/// A camera without noise and other effects.
CameraSimParams clean(const CameraModel& camera, int supersampling = 2);

/// Mean shift between two pictures, pixels, of the corners that can be tracked; NaN when there are few.
cv::Point2d mean_shift(const cv::Mat1b& from, const cv::Mat1b& to);

}  // namespace flownav::sim
