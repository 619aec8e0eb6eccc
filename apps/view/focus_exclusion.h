#pragma once
#include <opencv2/core/mat.hpp>

#include "flownav/core/camera_model.h"

namespace flownav::view {

/// The pixels of the camera where |e| < focus_exclusion: about the focus of expansion nothing moves enough while
/// the robot drives straight, and no block is placed there. 8-bit, 255 inside, one entry for `cell_px` x
/// `cell_px` pixels. Of the focus itself: where e vanishes, if that is in the image.
cv::Mat focus_exclusion_mask(const RayMapper& mapper, double focus_exclusion, int cell_px);

}  // namespace flownav::view
