#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "flownav/core/flow_vector.h"
#include "flownav/core/image_view.h"
#include "flownav/flow/block_layout.h"
#include "flownav/flow/match_blocks.h"

namespace flownav::flow {

/// Measures the flow of the blocks of a layout between two images of the same size. `predicted_px`: the flow
/// to start from, one per block. `vectors` gets one entry per block; one that was not measured is not
/// `valid`. A matcher may keep working memory between calls, but its results depend on the arguments only.
using Matcher =
    std::function<void(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                       const std::vector<Eigen::Vector2d>& predicted_px, std::vector<FlowVector>& vectors)>;

/// The default: exhaustive block matching in a window about the prediction, after compensation of the
/// brightness. Allocates only when the layout grows.
class BlockMatcher {
  public:
    BlockMatcher(const FlowParams& params, int threads, const KernelEntry& kernel = default_kernel());

    void operator()(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                    const std::vector<Eigen::Vector2d>& predicted_px, std::vector<FlowVector>& vectors);

  private:
    FlowParams params_;
    MatchSettings settings_;
    std::vector<Eigen::Vector2i> bias_px_;
    GreySums sums_;
};

}  // namespace flownav::flow
