#include "flownav/flow/match_blocks.h"

#include <algorithm>

#include "flownav/flow/subpixel.h"

namespace flownav {
namespace {

FlowVector match_one(const ImageView& reference, const ImageView& newer, const Eigen::Vector2i& corner_px,
                     const Eigen::Vector2i& bias_px, Subpixel subpixel, const KernelEntry& kernel) {
    FlowVector vector;
    vector.at_px = corner_px.cast<double>().array() + (block_px - 1) / 2.0;
    const SearchRange range = clipped_range(corner_px, bias_px, newer);
    if (range.empty()) return vector;
    const Eigen::Vector2i window = corner_px + bias_px;
    const BlockMatch match =
        kernel.match(reference.row(corner_px.y()) + corner_px.x(), reference.stride_bytes,
                     newer.data + window.y() * newer.stride_bytes + window.x(), newer.stride_bytes, range);
    vector.flow_px = bias_px.cast<double>() + refined_offset_px(match, subpixel);
    vector.sigma_px = sigma_px_of(match);
    vector.confidence = confidence_of(match);
    vector.valid = true;
    return vector;
}

}  // namespace

SearchRange clipped_range(const Eigen::Vector2i& corner_px, const Eigen::Vector2i& bias_px,
                          const ImageView& image) {
    const Eigen::Vector2i at = corner_px + bias_px;
    return {std::max(search_min, -at.x()), std::min(search_max, image.width_px - block_px - at.x()),
            std::max(search_min, -at.y()), std::min(search_max, image.height_px - block_px - at.y())};
}

void match_blocks(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                  const std::vector<Eigen::Vector2i>& bias_px, Subpixel subpixel, const KernelEntry& kernel,
                  int threads, std::vector<FlowVector>& vectors) {
    vectors.resize(layout.size());
    const int n = static_cast<int>(layout.size());
#pragma omp parallel for num_threads(threads) schedule(static) if (threads > 1)
    for (int i = 0; i < n; ++i) {
        vectors[i] = match_one(reference, newer, layout.corner_px[i], bias_px[i], subpixel, kernel);
    }
}

}  // namespace flownav
