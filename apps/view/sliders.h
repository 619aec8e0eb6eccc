#pragma once
#include <string>
#include <vector>

#include "flownav/config/config.h"

namespace flownav::view {

/// A parameter that can be changed while looking.
struct SliderKey {
    std::string key;    ///< section.key of the configuration
    std::string label;  ///< with its unit
    double low = 0.0;   ///< of the slider; the configuration may allow more
    double high = 1.0;
    double step = 0.01;
    double (*value)(const config::Config&) = nullptr;
};

const std::vector<SliderKey>& slider_keys();

/// The value of a slider at `share` (0..1) of its way, as text for the configuration.
std::string slider_text(const SliderKey& key, double share);

/// Where a slider stands, 0..1.
double slider_share(const SliderKey& key, const config::Config& config);

}  // namespace flownav::view
