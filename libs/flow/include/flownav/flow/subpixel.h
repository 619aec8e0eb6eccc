#pragma once
#include <Eigen/Core>
#include <algorithm>

#include "flownav/flow/kernel.h"
#include "flownav/flow/params.h"

namespace flownav::flow {

/// Offset of the true minimum from the integer one, in -0.5..0.5 px, from the costs before, at and behind it.
/// V: two lines of opposite slope through the three, right for a SAD; parabola: right for squared
/// differences. 0 where a neighbour is missing or the surface is flat.
inline double refine(int before, int at, int behind, Subpixel how) {
    if (how == Subpixel::None || before == no_cost || behind == no_cost) return 0.0;
    const double curvature =
        how == Subpixel::V ? 2.0 * (std::max(before, behind) - at) : 2.0 * (before + behind - 2 * at);
    if (curvature <= 0.0) return 0.0;
    return std::clamp((before - behind) / curvature, -0.5, 0.5);
}

/// (mu, nu) of a match, refined along u and v.
inline Eigen::Vector2d refined_offset_px(const BlockMatch& match, Subpixel how) {
    return {match.mu + refine(match.left, match.minimum, match.right, how),
            match.nu + refine(match.above, match.minimum, match.below, how)};
}

/// Standard deviation of the refined offset in u and v: the noise of a SAD, which the minimum itself tells,
/// over the slope beside the minimum. A straight edge has no slope along itself. Measured against exact flow
/// the law sigma = 0.03 + 0.05 minimum / slope holds from 0.05 to 1 px over all floors of tests/support.
inline Eigen::Vector2d sigma_px_of(const BlockMatch& match) {
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

/// (second - minimum) / second, 0..1; 0 where the minimum lies on the border of its window (a smaller cost
/// may lie outside) or where the window is too small to hold a second one.
inline double confidence_of(const BlockMatch& match) {
    const std::uint16_t beside = std::max({match.left, match.right, match.above, match.below});
    if (beside == no_cost || match.second == no_cost || match.second == 0) return 0.0;
    return static_cast<double>(match.second - match.minimum) / match.second;
}

}  // namespace flownav::flow
