#include "image_effects.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "flownav/math/units.h"
#include "flownav/sim/random.h"

namespace flownav::sim {
namespace {

constexpr int noise_samples = 1 << 17;
constexpr int exposure_every = 18;  ///< images, six more or less
constexpr int exposure_spread = 6;

/// A stream of its own for each use and each image.
Random stream(const CameraEffects& effects, std::uint64_t use, int image) {
    Random mixed(effects.seed * 0x9E3779B97F4A7C15U + use);
    return Random(mixed.bits() + static_cast<std::uint64_t>(image) * 0xD1B54A32D192ED03U);
}

/// Auto exposure after its step number `step`: each one goes up, down or back.
double level(const CameraEffects& effects, int step) {
    if (step <= 0) return 1.0;
    return 1.0 + effects.exposure_step * (stream(effects, 2, step).integer(0, 2) - 1);
}

}  // namespace

Tilt tilt_of_image(const CameraEffects& effects, int image) {
    Random random = stream(effects, 1, image);
    Tilt tilt;
    tilt.pitch_rad = random.normal(effects.pitch_vibration_deg) * degree_rad;
    tilt.roll_rad = random.normal(effects.roll_vibration_deg) * degree_rad;
    return tilt;
}

double gain_of_image(const CameraEffects& effects, int image) {
    const int step = image / exposure_every;
    const int change =
        step * exposure_every + stream(effects, 3, step).integer(0, 2 * exposure_spread) - exposure_spread;
    const int next_step = step + 1;
    const int next_change = next_step * exposure_every +
                            stream(effects, 3, next_step).integer(0, 2 * exposure_spread) - exposure_spread;
    const int reached = image >= next_change ? next_step : (image >= change ? step : step - 1);
    return effects.gain * level(effects, reached);
}

ImageEffects::ImageEffects(const CameraEffects& effects) : effects_(effects) {
    if (effects.noise_sigma <= 0.0) return;
    Random random = stream(effects, 4, 0);
    noise_.resize(noise_samples);
    for (float& value : noise_) value = static_cast<float>(random.normal(effects.noise_sigma));
}

/// Falls off with the square of the distance from the middle.
void ImageEffects::darken_corners(cv::Size size) {
    light_.create(size);
    const double half_x = 0.5 * (size.width - 1);
    const double half_y = 0.5 * (size.height - 1);
    for (int v = 0; v < size.height; ++v) {
        for (int u = 0; u < size.width; ++u) {
            const double x = (u - half_x) / (half_x + 0.5);
            const double y = (v - half_y) / (half_y + 0.5);
            light_(v, u) = static_cast<float>(1.0 - effects_.vignetting * 0.5 * (x * x + y * y));
        }
    }
}

void ImageEffects::apply(cv::Mat1b& picture, int image) {
    if (effects_.blur_px > 0.0)
        cv::GaussianBlur(picture, picture, {}, effects_.blur_px, effects_.blur_px, cv::BORDER_REPLICATE);
    const auto gain = static_cast<float>(gain_of_image(effects_, image));
    if (gain == 1.0F && effects_.vignetting <= 0.0 && noise_.empty()) return;
    if (light_.size() != picture.size()) darken_corners(picture.size());
    Random random = stream(effects_, 5, image);
    const std::vector<float> none(noise_.empty() ? static_cast<std::size_t>(picture.cols) : 0);
    for (int v = 0; v < picture.rows; ++v) {
        const float* noise = none.data();
        if (!noise_.empty()) noise = &noise_[random.integer(0, noise_samples - picture.cols)];
        std::uint8_t* row = picture[v];
        const float* light = light_[v];
        for (int u = 0; u < picture.cols; ++u) {
            const float grey = gain * light[u] * static_cast<float>(row[u]) + noise[u] + 0.5F;
            row[u] = static_cast<std::uint8_t>(std::min(std::max(grey, 0.0F), 255.0F));
        }
    }
}

}  // namespace flownav::sim
