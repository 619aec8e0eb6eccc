#pragma once
#include <algorithm>
#include <cmath>

#include "flownav/pipeline/params.h"

namespace flownav::pipeline {

// Within this time a robot that crawls is to see the floor before it move: the more fields a second, the more
// of them a cycle may have. A robot that stands gets a new reference as often.
constexpr double cycle_max_s = 0.48;
constexpr int cycle_images_max = 24;
constexpr int slow_camera_images = 8;

/// r for a robot that moves `travel_per_image_m` from image to image, every `interval_s`.
inline int plan_cycle(const RateParams& params, double travel_per_image_m, double interval_s) {
    if (params.cycle_images > 0) return params.cycle_images;
    const double most = std::round(cycle_max_s / std::max(interval_s, 1e-6));
    const double images = std::round(params.travel_m / std::max(std::abs(travel_per_image_m), 1e-6));
    return static_cast<int>(
        std::clamp(images, 1.0, std::clamp<double>(most, slow_camera_images, cycle_images_max)));
}

}  // namespace flownav::pipeline
