#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "flownav/core/image_view.h"
#include "flownav/flow/block_layout.h"

namespace flownav::flow {

/// Change of exposure between two images: newer = gain * reference + offset, in grey levels.
struct Brightness {
    double gain = 1.0;
    double offset = 0.0;
};

/// A Brightness in 16-bit fixed point, for SIMD: shown = (grey * gain + offset) >> 5. `gain` is in units of
/// 1/16384 and its product is truncated to 1/32 grey level; `offset` includes the half that rounds. Exact for
/// the identity.
struct GreyMap {
    std::int16_t gain = unit_gain;
    std::int16_t offset = half;

    static constexpr std::int16_t unit_gain = 1 << 14;
    static constexpr std::int16_t half = 16;

    GreyMap() = default;
    explicit GreyMap(const Brightness& brightness);

    std::uint8_t operator()(std::uint8_t grey) const {
        const int scaled = (grey << 7) * gain >> 16;
        return static_cast<std::uint8_t>(std::clamp((scaled + offset) >> 5, 0, 255));
    }
    bool is_identity() const { return gain == unit_gain && offset >= 0 && offset < 2 * half; }
};

/// Grey level in the newer image for each grey level of the reference.
using GreyTable = std::array<std::uint8_t, 256>;

GreyTable grey_table(const Brightness& brightness);

/// Sums of the blocks' pixels in the two images; working memory of compare_brightness().
struct GreySums {
    std::vector<double> reference, reference2;  ///< sums of a block's grey levels and of their squares
    std::vector<double> newer, newer2;
    std::vector<double> difference;  ///< of the newer sum from the one that the brightness predicts, absolute
    std::vector<double> sorted;
};

/// Estimates the change of brightness from the blocks of the reference and their expected places in the newer
/// image, displaced by `bias_px` (one per block). The gain comes from the standard deviations of all pixels,
/// the offset from the means, so a misplaced block costs precision only. Uses the first 192 blocks and leaves
/// out the 30 % that fit worst (occlusions, highlights). Returns the identity when no block can be compared.
/// Allocates only when `sums` has to grow.
Brightness compare_brightness(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                              const std::vector<Eigen::Vector2i>& bias_px, GreySums& sums);

}  // namespace flownav::flow
