#include "flownav/flow/matcher.h"

#include "flownav/flow/block_bounds.h"

namespace flownav::flow {

BlockMatcher::BlockMatcher(const FlowParams& params, int threads, const KernelEntry& kernel)
    : params_(params) {
    settings_.subpixel = params.subpixel;
    settings_.kernel = &kernel;
    settings_.threads = threads;
}

void BlockMatcher::operator()(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                              const std::vector<Eigen::Vector2d>& predicted_px,
                              std::vector<FlowVector>& vectors) {
    bias_px_.resize(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i) bias_px_[i] = whole_px(predicted_px[i]);
    settings_.brightness = {};
    if (params_.brightness == BrightnessModel::Image)
        settings_.brightness = compare_brightness(reference, newer, layout, bias_px_, sums_);
    match_blocks(reference, newer, layout, bias_px_, settings_, vectors);
}

}  // namespace flownav::flow
