#pragma once

#include <opencv2/core/mat.hpp>

#include "flownav/core/camera_model.h"

namespace flownav::sim {

/// The pinhole picture that a camera's image is made of, `supersampling` times finer. Its intrinsics count
/// from the corner of the first pixel, as OpenGL has it: a pixel's centre is at a half.
struct Pinhole {
    cv::Size size_px;
    double fx_px = 0.0;
    double fy_px = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
};

/// A lens: large enough a pinhole picture, and where in it each pixel of the supersampled image lies. The
/// tables are empty when the lens does not distort.
struct Lens {
    Pinhole pinhole;
    cv::Mat1f map_x;
    cv::Mat1f map_y;
};

/// Throws std::invalid_argument when the distortion bends rays by more than a pinhole picture of three times
/// the size can hold.
Lens make_lens(const CameraModel& camera, int supersampling);

}  // namespace flownav::sim
