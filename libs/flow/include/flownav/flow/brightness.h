#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "flownav/core/image_view.h"
#include "flownav/flow/block_layout.h"

namespace flownav::flow {

/// How the exposure changed between two images: newer = gain * reference + offset, in grey levels.
struct Brightness {
    double gain = 1.0;
    double offset = 0.0;
};

/// The same in 16-bit numbers, of which processors change many at once: shown = (grey * gain + offset) >> 5,
/// with `gain` in 1/16384, its product cut to 1/32 grey level, and the half that rounds in `offset`. Exact
/// where nothing changes.
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

/// The grey level that the newer image shows for each grey level of the reference.
using GreyTable = std::array<std::uint8_t, 256>;

GreyTable grey_table(const Brightness& brightness);

/// What the pixels of the blocks add up to in the two images; working memory of compare_brightness().
struct GreySums {
    std::vector<double> reference, reference2;  ///< grey levels of a block, and their squares
    std::vector<double> newer, newer2;
    std::vector<double> difference;  ///< of the block's sum from what the brightness says
    std::vector<double> sorted;
};

/// Compares the blocks of the reference with the places where they are expected in the newer image
/// (`bias_px` further, one per block): gain from the deviations of all their pixels, offset from the means.
/// Being statistics they need no alignment: a wrong expectation costs precision, not truth. The first
/// 192 blocks are enough: more say the same. Blocks that do not follow the others (something moved in, a
/// highlight) are left out. No change where nothing can be compared. Allocates only when `sums` has to grow.
Brightness compare_brightness(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                              const std::vector<Eigen::Vector2i>& bias_px, GreySums& sums);

}  // namespace flownav::flow
