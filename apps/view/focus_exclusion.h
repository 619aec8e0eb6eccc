#pragma once
#include <opencv2/core/mat.hpp>

#include "flownav/core/camera_model.h"

namespace flownav::view {

/// Mask of the camera pixels where |e| < focus_exclusion. Near the focus of expansion the flow of a straight
/// drive is too small, and no block is placed there. 8-bit, 255 inside, one entry per `cell_px` x `cell_px`
/// pixels.
cv::Mat focus_exclusion_mask(const RayMapper& mapper, double focus_exclusion, int cell_px);

}  // namespace flownav::view
