#include "sliders.h"

#include <algorithm>
#include <cmath>

#include "flownav/cli/number_text.h"

namespace flownav::view {

const std::vector<SliderKey>& slider_keys() {
    static const std::vector<SliderKey> keys = {
        {"flow.blocks", "blocks", 50, 1000, 10,
         [](const config::Config& c) { return static_cast<double>(c.pipeline.flow.blocks); }},
        {"flow.confidence_min", "confidence", 0.0, 0.4, 0.01,
         [](const config::Config& c) { return c.pipeline.flow.confidence_min; }},
        {"flow.focus_exclusion", "blind cone", 0.0, 0.6, 0.01,
         [](const config::Config& c) { return c.pipeline.flow.focus_exclusion; }},
        {"obstacles.lambda_px", "lambda px", 0.1, 4.0, 0.05,
         [](const config::Config& c) { return c.pipeline.obstacles.lambda_px; }},
        {"obstacles.tau_px", "tau px", 0.25, 5.0, 0.05,
         [](const config::Config& c) { return c.pipeline.obstacles.tau_px; }},
        {"obstacles.neighbours", "neighbours", 0, 8, 1,
         [](const config::Config& c) { return static_cast<double>(c.pipeline.obstacles.neighbours); }},
        {"motion.cycle_images", "images/cycle", 0, 12, 1,
         [](const config::Config& c) { return static_cast<double>(c.pipeline.rate.cycle_images); }},
    };
    return keys;
}

std::string slider_text(const SliderKey& key, double share) {
    const double wanted = key.low + std::clamp(share, 0.0, 1.0) * (key.high - key.low);
    const double value = std::clamp(std::round(wanted / key.step) * key.step, key.low, key.high);
    if (key.key == "motion.cycle_images" && value < 0.5) return "auto";
    return cli::fixed_text(value, key.step >= 1.0 ? 0 : 2);
}

double slider_share(const SliderKey& key, const config::Config& config) {
    return std::clamp((key.value(config) - key.low) / (key.high - key.low), 0.0, 1.0);
}

}  // namespace flownav::view
