#pragma once
#include <cstdint>

#include "flownav/testing/render.h"

namespace flownav::testing {

/// Effects of the camera and the floor on a whole drive. All are drawn anew for every image, from the seed.
struct CameraEffects {
    double noise_sigma = 2.5;    ///< grey levels
    double gain_sigma = 0.0;     ///< of the exposure from image to image
    double offset_sigma = 0.0;   ///< grey levels
    double exposure_step = 0.0;  ///< share by which auto exposure steps up or down every 12 to 24 images
    double flicker = 0.0;        ///< amplitude of the lamps' brightness as a share of it, a sine
    double flicker_period_images = 3.3;  ///< 100 Hz lamps aliased by the images' rate
    double vignetting = 0.25;            ///< share of light lost in the corners
    int grey_step = 1;                   ///< greys are multiples of this
    double pitch_vibration_rad = 0.0;    ///< standard deviation
    double roll_vibration_rad = 0.0;     ///< standard deviation
    double exposure_s = 0.0;     ///< the shutter is open this long about the image's time: motion blur
    double floor_sigma_m = 0.0;  ///< of the camera's height over the ground
    std::uint64_t seed = 1;
};

/// The effects on image i.
ImageEffects effects_of_image(const CameraEffects& effects, int i);

}  // namespace flownav::testing
