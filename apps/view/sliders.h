#pragma once
#include <string>
#include <vector>

#include "flownav/config/config.h"

namespace flownav::view {

/// A parameter with a slider.
struct SliderKey {
    std::string key;    ///< section.key of the configuration
    std::string label;  ///< label with unit
    double low = 0.0;   ///< range of the slider; the configuration may allow more
    double high = 1.0;
    double step = 0.01;
    double (*value)(const config::Config&) = nullptr;
};

const std::vector<SliderKey>& slider_keys();

/// Converts a slider position (0..1) to the text of the configuration value.
std::string slider_text(const SliderKey& key, double share);

/// Converts a configuration value to its slider position, 0..1.
double slider_share(const SliderKey& key, const config::Config& config);

}  // namespace flownav::view
