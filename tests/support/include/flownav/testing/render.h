#pragma once
#include <cstdint>
#include <vector>

#include "flownav/testing/grey_image.h"
#include "flownav/testing/truth.h"

namespace flownav::testing {

/// Effects of the camera and the drive on ONE image.
struct ImageEffects {
    double gain = 1.0;
    double offset = 0.0;       ///< grey levels
    double noise_sigma = 0.0;  ///< grey levels
    std::uint64_t noise_seed = 0;
    double vignetting = 0.0;  ///< share of light lost in the corners, 0..1
    int grey_step = 1;        ///< greys are multiples of this: a coarse digitiser, pictures pack better
    double pitch_rad = 0.0;   ///< added to the mount: vibration
    double roll_rad = 0.0;
    double height_m = 0.0;  ///< added to the mount: uneven floor
};

/// The camera with the image's vibration and floor added to its mount: the camera that really took the image.
CameraModel with_effects(CameraModel camera, const ImageEffects& effects);

/// Renders the world as the view sees it. Integer pixel coordinates are pixel centres. Deterministic: the
/// same arguments give the same bytes with any number of threads.
GreyImage render(const World& world, const View& view, const ImageEffects& effects = {});

/// The same for a shutter that stays open while the camera moves through several views: motion blur.
/// Throws std::invalid_argument when there is no view.
GreyImage render(const World& world, const std::vector<View>& during_exposure,
                 const ImageEffects& effects = {});

}  // namespace flownav::testing
