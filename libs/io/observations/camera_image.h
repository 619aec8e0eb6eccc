#pragma once
#include <mrpt/obs/CObservationImage.h>

namespace flownav::io {

/// The picture an observation holds, with its calibration and optical pose: an image as it is, or the
/// intensity image of a depth camera. Null when there is none. No pixel is copied.
mrpt::obs::CObservationImage::Ptr camera_image(const mrpt::obs::CObservation::Ptr& observation);

}  // namespace flownav::io
