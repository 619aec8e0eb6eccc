#include "flownav/flow/brightness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "block_greys.h"
#include "flownav/flow/block_bounds.h"
#include "flownav/math/order_statistic.h"

namespace flownav::flow {
namespace {

constexpr double block_pixels = static_cast<double>(block_px) * block_px;
constexpr double gain_max = 2.0;      // largest gain, and inverse of the smallest
constexpr double variance_min = 1.0;  // grey levels squared; below, the gain is not determined
constexpr int rounds = 3;
constexpr std::size_t blocks_max = 192;  // the first ones; any number of first blocks covers the image evenly
constexpr double kept_share = 0.7;       // share of the blocks with the smallest differences

void collect(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
             const std::vector<Eigen::Vector2i>& bias_px, GreySums& sums) {
    for (auto* numbers : {&sums.reference, &sums.reference2, &sums.newer, &sums.newer2}) numbers->clear();
    const std::size_t blocks = std::min(layout.size(), blocks_max);
    for (std::size_t i = 0; i < blocks; ++i) {
        const Eigen::Vector2i& corner_px = layout.corner_px[i];
        if (!contains_block(reference, corner_px) || !contains_block(newer, corner_px, bias_px[i])) continue;
        const Eigen::Vector2i expected_px = corner_px + bias_px[i];
        const BlockSums before =
            sums_of(reference.row(corner_px.y()) + corner_px.x(), reference.stride_bytes);
        const BlockSums after = sums_of(newer.row(expected_px.y()) + expected_px.x(), newer.stride_bytes);
        sums.reference.push_back(before.greys);
        sums.reference2.push_back(before.squares);
        sums.newer.push_back(after.greys);
        sums.newer2.push_back(after.squares);
    }
    sums.difference.assign(sums.newer.size(), 0.0);
}

/// Fits gain and offset to the blocks whose difference is at most `difference_max`.
Brightness fit(const GreySums& sums, double difference_max) {
    double used = 0.0, greys = 0.0, squares = 0.0, newer_greys = 0.0, newer_squares = 0.0;
    for (std::size_t i = 0; i < sums.newer.size(); ++i) {
        const bool counts = sums.difference[i] <= difference_max;
        used += counts ? 1.0 : 0.0;
        greys += counts ? sums.reference[i] : 0.0;
        squares += counts ? sums.reference2[i] : 0.0;
        newer_greys += counts ? sums.newer[i] : 0.0;
        newer_squares += counts ? sums.newer2[i] : 0.0;
    }
    const double n = block_pixels * used;
    const double mean = greys / n;
    const double newer_mean = newer_greys / n;
    const double variance = squares / n - mean * mean;
    const double newer_variance = newer_squares / n - newer_mean * newer_mean;
    Brightness b;
    if (variance > variance_min && newer_variance > variance_min)
        b.gain = std::clamp(std::sqrt(newer_variance / variance), 1.0 / gain_max, gain_max);
    b.offset = newer_mean - b.gain * mean;
    return b;
}

/// Updates the differences of all blocks and returns their kept_share quantile.
double difference_of_kept(const Brightness& b, GreySums& sums) {
    for (std::size_t i = 0; i < sums.difference.size(); ++i)
        sums.difference[i] = std::abs(sums.newer[i] - b.gain * sums.reference[i] - b.offset * block_pixels);
    sums.sorted = sums.difference;
    const auto kept =
        static_cast<std::size_t>(std::ceil(kept_share * static_cast<double>(sums.sorted.size())));
    return nth_smallest(sums.sorted, kept - 1);
}

}  // namespace

GreyMap::GreyMap(const Brightness& brightness) {
    constexpr double gain_limit = std::numeric_limits<std::int16_t>::max();
    constexpr double offset_limit = 16000;  // 500 grey levels, beyond the range of an 8-bit image
    const double gain_wanted = std::round(unit_gain * brightness.gain);
    const double offset_wanted = std::round(32.0 * brightness.offset + half);
    gain = static_cast<std::int16_t>(std::clamp(gain_wanted, 0.0, gain_limit));
    offset = static_cast<std::int16_t>(std::clamp(offset_wanted, -offset_limit, offset_limit));
}

GreyTable grey_table(const Brightness& brightness) {
    const GreyMap shown(brightness);
    GreyTable table;
    for (std::size_t grey = 0; grey < table.size(); ++grey)
        table[grey] = shown(static_cast<std::uint8_t>(grey));
    return table;
}

Brightness compare_brightness(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                              const std::vector<Eigen::Vector2i>& bias_px, GreySums& sums) {
    collect(reference, newer, layout, bias_px, sums);
    if (sums.newer.empty()) return {};
    Brightness b = fit(sums, 0.0);  // all blocks: all differences are 0
    for (int round = 0; round < rounds; ++round) b = fit(sums, difference_of_kept(b, sums));
    return b;
}

}  // namespace flownav::flow
