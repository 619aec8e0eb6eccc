#pragma once
#include <Eigen/Core>
#include <vector>

#include "flownav/core/flow_vector.h"
#include "flownav/core/image_view.h"
#include "flownav/flow/block_layout.h"
#include "flownav/flow/brightness.h"
#include "flownav/flow/kernel.h"
#include "flownav/flow/params.h"

namespace flownav::flow {

/// Returns the part of a block's search window that lies inside the image. `corner_px`: top left pixel of the
/// block; `bias_px`: displacement of the window's centre. Empty when no part does. Safe for any values.
SearchRange clipped_range(const Eigen::Vector2i& corner_px, const Eigen::Vector2i& bias_px,
                          const ImageView& image);

struct MatchSettings {
    Subpixel subpixel = Subpixel::V;
    const KernelEntry* kernel = &default_kernel();
    int threads = 1;  ///< does not change the result
    Brightness brightness;
};

/// Measures the displacement of every block of the layout between two images of the same size. `bias_px`:
/// displacement of each search window, one per block. Blocks are first adapted to the newer image's
/// brightness, in whole grey levels, so the sums stay exact. `vectors` gets one entry per block; `valid` is
/// false where the block lies outside the reference or its window outside the newer image. Never reads pixels
/// outside an image. Allocates only when `vectors` has to grow.
void match_blocks(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                  const std::vector<Eigen::Vector2i>& bias_px, const MatchSettings& settings,
                  std::vector<FlowVector>& vectors);

}  // namespace flownav::flow
