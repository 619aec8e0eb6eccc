#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "flownav/sim/camera_simulator.h"

namespace flownav::sim {

/// The tilt of a shaking camera, over what its mount says.
struct Tilt {
    double pitch_rad = 0.0;
    double roll_rad = 0.0;
};
Tilt tilt_of_image(const CameraEffects& effects, int image);

/// Exposure of an image: gain and the steps of auto exposure.
double gain_of_image(const CameraEffects& effects, int image);

/// Blur, exposure, vignetting and noise on images of one size.
class ImageEffects {
  public:
    explicit ImageEffects(const CameraEffects& effects);

    /// Grey to grey, in place.
    void apply(cv::Mat1b& picture, int image);

  private:
    void darken_corners(cv::Size size);

    CameraEffects effects_;
    std::vector<float> noise_;  ///< drawn once; every row of every image begins elsewhere in it
    cv::Mat1f light_;           ///< share that reaches each pixel
};

}  // namespace flownav::sim
