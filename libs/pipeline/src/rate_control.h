#pragma once
#include <algorithm>
#include <cmath>

#include "flownav/pipeline/params.h"

namespace flownav::pipeline {

constexpr int cycle_images_max = 8;  ///< a robot that stands still also gets a new reference now and then

/// r for a robot that moves `travel_per_image_m` from image to image.
inline int plan_cycle(const RateParams& params, double travel_per_image_m) {
    if (params.cycle_images > 0) return params.cycle_images;
    const double images = params.travel_m / std::max(std::abs(travel_per_image_m), 1e-6);
    return static_cast<int>(std::clamp(std::round(images), 1.0, static_cast<double>(cycle_images_max)));
}

}  // namespace flownav::pipeline
