#include "flownav/testing/effects.h"

#include <cmath>
#include <cstdlib>

#include "flownav/sim/random.h"

namespace flownav::testing {
namespace {

using sim::HashRandom;
using sim::mix;

constexpr int slot_images = 18;  // every slot holds one step of the exposure, in its first third
constexpr int steps_max = 2;     // up or down from the middle

/// Exposure held since the last step: a walk over the steps' powers that turns back at its ends.
double stepped_exposure(const CameraEffects& effects, int i) {
    if (effects.exposure_step == 0.0) return 1.0;
    HashRandom random(mix(effects.seed, 0x6578706FU));
    int level = 0;
    for (int slot = 0; slot * slot_images <= i; ++slot) {
        const int at = slot * slot_images + static_cast<int>(random.uniform(0.0, slot_images / 3.0));
        int direction = random.uniform(0.0, 1.0) < 0.5 ? -1 : 1;
        if (at > i) break;
        if (std::abs(level + direction) > steps_max) direction = -direction;
        level += direction;
    }
    return std::pow(1.0 + effects.exposure_step, level);
}

double lamps(const CameraEffects& effects, int i) {
    return 1.0 + effects.flicker * std::sin(2.0 * M_PI * i / effects.flicker_period_images);
}

}  // namespace

ImageEffects effects_of_image(const CameraEffects& effects, int i) {
    HashRandom random(mix(effects.seed, static_cast<std::uint64_t>(i)));
    ImageEffects image;
    image.gain = (1.0 + random.normal(effects.gain_sigma)) * stepped_exposure(effects, i) * lamps(effects, i);
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
