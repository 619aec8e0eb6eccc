#pragma once
#include <optional>
#include <string>

#include "markdown.h"

namespace flownav::fidelity {

/// Targets for the figures of one scene; empty for figures without a target.
struct Targets {
    std::optional<Target> omega_image_degps, omega_cycle_degps, t_bias_percent, t_scatter_percent;
    std::optional<Target> ghosts_per_cycle, false_per_cycle, detected_percent;
    std::optional<Target> error_1_2_m, error_2_3_m, error_3_4_m, chair_percent;
    std::optional<Target> map_precise_percent, map_found_percent;
    std::optional<Target> covered_degps, heading_deg;
};

Targets targets_of(const std::string& scene);

}  // namespace flownav::fidelity
