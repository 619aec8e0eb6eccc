#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "flownav/core/image_view.h"
#include "flownav/flow/block_layout.h"

namespace flownav {

/// How the exposure changed between two images: newer = gain * reference + offset, in grey levels.
struct Brightness {
    double gain = 1.0;
    double offset = 0.0;
};

/// The grey level that the newer image shows for each grey level of the reference.
using GreyTable = std::array<std::uint8_t, 256>;

GreyTable grey_table(const Brightness& brightness);

/// What the pixels of one block add up to in the two images.
struct GreySums {
    double reference = 0.0, reference2 = 0.0;  ///< grey levels, and their squares
    double newer = 0.0, newer2 = 0.0;
    double difference = 0.0;  ///< of the block's mean from what the brightness says
};

/// Compares the blocks of the reference with the places where they are expected in the newer image
/// (`bias_px` further, one per block): gain from the deviations of all their pixels, offset from the means.
/// Being statistics they need no alignment: a wrong expectation costs precision, not truth. Blocks that do
/// not follow the others (something moved in, a highlight) are left out. No change where nothing can be
/// compared. `sums` is working memory.
Brightness compare_brightness(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                              const std::vector<Eigen::Vector2i>& bias_px, std::vector<GreySums>& sums);

}  // namespace flownav
