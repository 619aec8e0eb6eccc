#include "flownav/testing/render.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "flownav/testing/random.h"
#include "scene_painter.h"

namespace flownav::testing {
namespace {

constexpr int tile_px = 16;

std::vector<float> paint(const World& world, const View& view) {
    const ScenePainter painter(world, view);
    std::vector<float> light(static_cast<std::size_t>(painter.width()) *
                             static_cast<std::size_t>(painter.height()));
    const int columns = (painter.width() + tile_px - 1) / tile_px;
    const int rows = (painter.height() + tile_px - 1) / tile_px;
#pragma omp parallel for schedule(dynamic)
    for (int tile = 0; tile < columns * rows; ++tile) {
        const int u = tile % columns * tile_px;
        const int v = tile / columns * tile_px;
        painter.paint_tile(u, v, std::min(u + tile_px, painter.width()),
                           std::min(v + tile_px, painter.height()), light);
    }
    return light;
}

std::vector<float> mean_light(const World& world, const std::vector<View>& views,
                              const ImageEffects& effects) {
    if (views.empty()) throw std::invalid_argument("an image needs at least one view");
    std::vector<float> sum;
    for (View view : views) {
        view.camera = with_effects(view.camera, effects);
        const std::vector<float> light = paint(world, view);
        sum.resize(light.size());
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
    const std::vector<float> light = mean_light(world, during_exposure, effects);
    const CameraModel& camera = during_exposure.front().camera;
    GreyImage image(camera.width_px, camera.height_px);
    for (std::size_t i = 0; i < light.size(); ++i) {
        const int u = static_cast<int>(i) % image.width_px;
        const int v = static_cast<int>(i) / image.width_px;
        const double noise = effects.noise_sigma * normal_of_bits(mix(effects.noise_seed, i));
        const double falloff = vignette(camera, effects.vignetting, u, v);
        const double grey = effects.gain * falloff * static_cast<double>(light[i]) + effects.offset + noise;
        image.pixels[i] = digitise(grey, effects.grey_step);
    }
    return image;
}

}  // namespace flownav::testing
