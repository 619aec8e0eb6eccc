#pragma once
#include <mrpt/obs/CObservationImage.h>

namespace flownav::io {

/// Returns the picture of an observation, with calibration and optical pose: an image itself, the
/// intensity image of a depth camera, or the left image of a stereo camera. Null when there is none. Shares
/// the pixels.
mrpt::obs::CObservationImage::Ptr camera_image(const mrpt::obs::CObservation::Ptr& observation);

}  // namespace flownav::io
