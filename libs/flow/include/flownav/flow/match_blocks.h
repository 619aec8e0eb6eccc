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

/// Part of the search window of a block (top left pixel `corner_px`) that lies inside the image when its
/// centre is displaced by `bias_px`; empty when nothing is left. Holds for any numbers.
SearchRange clipped_range(const Eigen::Vector2i& corner_px, const Eigen::Vector2i& bias_px,
                          const ImageView& image);

struct MatchSettings {
    Subpixel subpixel = Subpixel::V;
    const KernelEntry* kernel = &default_kernel();
    int threads = 1;  ///< the result does not depend on it
    Brightness brightness;
};

/// The motion estimation processor: measures every block of the layout between two images of the same size.
/// bias_px: displacement of each search window, one per block. The greys of each block are brought to the
/// newer image's brightness before they are matched, in whole grey levels: the sums stay exact. `vectors`
/// gets one entry per block; `valid` is false where the block lies outside the reference, or no window is
/// left in the newer image: no pixel outside an image is read, whatever the positions and biases. Allocates
/// only when `vectors` has to grow.
void match_blocks(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                  const std::vector<Eigen::Vector2i>& bias_px, const MatchSettings& settings,
                  std::vector<FlowVector>& vectors);

}  // namespace flownav::flow
