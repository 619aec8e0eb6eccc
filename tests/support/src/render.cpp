#include "flownav/testing/render.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "flownav/sim/random.h"
#include "flownav/sim/ray_caster.h"

namespace flownav::testing {
namespace {

cv::Mat1f mean_light(const World& world, const std::vector<View>& views, const ImageEffects& effects) {
    if (views.empty()) throw std::invalid_argument("an image needs at least one view");
    cv::Mat1f sum;
    for (View view : views) {
        view.camera = with_effects(view.camera, effects);
        const cv::Mat1f light = sim::cast_light(world, view);
        if (sum.empty()) sum = cv::Mat1f(light.size(), 0.0F);
        std::transform(sum.begin(), sum.end(), light.begin(), sum.begin(), std::plus<>());
    }
    for (float& grey : sum) grey /= static_cast<float>(views.size());
    return sum;
}

/// Share of the light that reaches a pixel: falls with the square of the distance from the middle.
double vignette(const CameraModel& camera, double share, int u, int v) {
    const double x = (2.0 * u + 1.0) / camera.width_px - 1.0;
    const double y = (2.0 * v + 1.0) / camera.height_px - 1.0;
    return 1.0 - 0.5 * share * (x * x + y * y);
}

std::uint8_t digitise(double grey, int step) {
    const double highest = 255.0 - 255 % step;
    return static_cast<std::uint8_t>(step * std::lround(std::clamp(grey, 0.0, highest) / step));
}

}  // namespace

CameraModel with_effects(CameraModel camera, const ImageEffects& effects) {
    camera.mount.pitch_rad += effects.pitch_rad;
    camera.mount.roll_rad += effects.roll_rad;
    camera.mount.height_m += effects.height_m;
    return camera;
}

GreyImage render(const World& world, const View& view, const ImageEffects& effects) {
    return render(world, std::vector<View>{view}, effects);
}

GreyImage render(const World& world, const std::vector<View>& during_exposure, const ImageEffects& effects) {
    const cv::Mat1f light = mean_light(world, during_exposure, effects);
    const CameraModel& camera = during_exposure.front().camera;
    GreyImage image(camera.width_px, camera.height_px);
    std::uint64_t i = 0;
    for (int v = 0; v < image.height_px; ++v) {
        for (int u = 0; u < image.width_px; ++u, ++i) {
            const double noise = effects.noise_sigma * sim::normal_of_bits(sim::mix(effects.noise_seed, i));
            const double falloff = vignette(camera, effects.vignetting, u, v);
            const double grey =
                effects.gain * falloff * static_cast<double>(light(v, u)) + effects.offset + noise;
            image.row(v)[u] = digitise(grey, effects.grey_step);
        }
    }
    return image;
}

}  // namespace flownav::testing
