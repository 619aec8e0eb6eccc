#include "flownav/flow/subpixel.h"

#include <algorithm>

namespace flownav {

double refine(int before, int at, int behind, Subpixel how) {
    if (how == Subpixel::None || before == no_cost || behind == no_cost) return 0.0;
    const double curvature =
        how == Subpixel::V ? 2.0 * (std::max(before, behind) - at) : 2.0 * (before + behind - 2 * at);
    if (curvature <= 0.0) return 0.0;
    return std::clamp((before - behind) / curvature, -0.5, 0.5);
}

Eigen::Vector2d refined_offset_px(const BlockMatch& match, Subpixel how) {
    return {match.mu + refine(match.left, match.minimum, match.right, how),
            match.nu + refine(match.above, match.minimum, match.below, how)};
}

Eigen::Vector2d sigma_px_of(const BlockMatch& match) {
    constexpr double floor_px = 0.03;
    constexpr double noise_share = 0.05;  // deviation of a SAD over the SAD
    constexpr double worst_px = 10.0;     // what the window allows
    const auto sigma = [&](std::uint16_t before, std::uint16_t behind) {
        const double slope = std::max(before, behind) - match.minimum;
        const double noise = noise_share * std::max<double>(match.minimum, block_px * block_px / 4.0);
        return std::min(worst_px, floor_px + noise / std::max(slope, 1.0));
    };
    return {sigma(match.left, match.right), sigma(match.above, match.below)};
}

double confidence_of(const BlockMatch& match) {
    const std::uint16_t beside = std::max({match.left, match.right, match.above, match.below});
    if (beside == no_cost || match.second == no_cost || match.second == 0) return 0.0;
    return static_cast<double>(match.second - match.minimum) / match.second;
}

}  // namespace flownav
