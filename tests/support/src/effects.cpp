#include "flownav/testing/effects.h"

#include "flownav/testing/random.h"

namespace flownav::testing {

ImageEffects effects_of_image(const CameraEffects& effects, int i) {
    Random random(mix(effects.seed, static_cast<std::uint64_t>(i)));
    ImageEffects image;
    image.gain = 1.0 + random.normal(effects.gain_sigma);
    image.offset = random.normal(effects.offset_sigma);
    image.pitch_rad = random.normal(effects.pitch_vibration_rad);
    image.roll_rad = random.normal(effects.roll_vibration_rad);
    image.height_m = random.normal(effects.floor_sigma_m);
    image.noise_sigma = effects.noise_sigma;
    image.noise_seed = random.bits();
    image.vignetting = effects.vignetting;
    image.grey_step = effects.grey_step;
    return image;
}

}  // namespace flownav::testing
