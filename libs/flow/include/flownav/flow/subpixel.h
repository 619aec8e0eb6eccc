#pragma once
#include <Eigen/Core>
#include <algorithm>

#include "flownav/flow/kernel.h"
#include "flownav/flow/params.h"

namespace flownav::flow {

/// Offset of the true minimum from the integer one, -0.5..0.5 px, from the costs before, at and behind it. V
/// fits two lines of opposite slope, the shape of a SAD; Parabola fits the shape of squared differences. 0
/// where a neighbour is missing or the surface is flat.
inline double refine(int before, int at, int behind, Subpixel how) {
    if (how == Subpixel::None || before == no_cost || behind == no_cost) return 0.0;
    const double curvature =
        how == Subpixel::V ? 2.0 * (std::max(before, behind) - at) : 2.0 * (before + behind - 2 * at);
    if (curvature <= 0.0) return 0.0;
    return std::clamp((before - behind) / curvature, -0.5, 0.5);
}

/// Returns (mu, nu) of a match in px, refined along u and v.
inline Eigen::Vector2d refined_offset_px(const BlockMatch& match, Subpixel how) {
    return {match.mu + refine(match.left, match.minimum, match.right, how),
            match.nu + refine(match.above, match.minimum, match.below, how)};
}

/// Standard deviation of the refined offset in u and v, in px: the noise of the SAD, which is proportional to
/// the minimum, over the slope beside the minimum. Along a straight edge the slope is 0. Compared with exact
/// flow, sigma = 0.03 + 0.05 minimum / slope holds from 0.05 to 1 px on all floors of tests/support.
inline Eigen::Vector2d sigma_px_of(const BlockMatch& match) {
    constexpr double floor_px = 0.03;
    constexpr double noise_share = 0.05;  // standard deviation of a SAD over the SAD
    constexpr double worst_px = 10.0;     // limit set by the search window
    const auto sigma = [&](std::uint16_t before, std::uint16_t behind) {
        const double slope = std::max(before, behind) - match.minimum;
        const double noise = noise_share * std::max<double>(match.minimum, block_px * block_px / 4.0);
        return std::min(worst_px, floor_px + noise / std::max(slope, 1.0));
    };
    return {sigma(match.left, match.right), sigma(match.above, match.below)};
}

/// Returns (second - minimum) / second, 0..1. 0 where the minimum lies on the border of its window (a smaller
/// cost may lie outside) or the window holds no second minimum.
inline double confidence_of(const BlockMatch& match) {
    const std::uint16_t beside = std::max({match.left, match.right, match.above, match.below});
    if (beside == no_cost || match.second == no_cost || match.second == 0) return 0.0;
    return static_cast<double>(match.second - match.minimum) / match.second;
}

}  // namespace flownav::flow
