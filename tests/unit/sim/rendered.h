#pragma once

#include <opencv2/core/mat.hpp>

#include "flownav/sim/camera_simulator.h"
#include "flownav/testing/scene.h"

namespace flownav::sim {

/// The shapes of an analytic world, with looks of this library; what moves there moves for `until_s`.
World same_world(const testing::World& world, double until_s = 10.0);

/// A copy of the pixels.
cv::Mat1b picture_of(const Field& field);

/// A camera without noise or any other effect.
CameraSimParams clean(const CameraModel& camera, int supersampling = 2);

/// Mean shift of what both pictures show, in pixels, where it can be followed.
cv::Point2d mean_shift(const cv::Mat1b& from, const cv::Mat1b& to);

}  // namespace flownav::sim
