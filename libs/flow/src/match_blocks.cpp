#include "flownav/flow/match_blocks.h"

#include <algorithm>
#include <cstdint>

#include "block_greys.h"
#include "flownav/flow/block_bounds.h"
#include "flownav/flow/subpixel.h"

namespace flownav::flow {
namespace {

/// Matches a block after mapping its brightness. `block`: its top left pixel in the reference; `window`: the
/// pixel at offset (0, 0) in the newer image.
BlockMatch match_of(const std::uint8_t* block, std::ptrdiff_t stride, const std::uint8_t* window,
                    std::ptrdiff_t window_stride, const SearchRange& range, const MatchKernel& match,
                    const GreyMap& greys) {
    if (greys.is_identity()) return match(block, stride, window, window_stride, range);
    const GreyBlock shown = shown_block(block, stride, greys);
    return match(shown.pixels.data(), block_px, window, window_stride, range);
}

FlowVector match_one(const ImageView& reference, const ImageView& newer, const Eigen::Vector2i& corner_px,
                     const Eigen::Vector2i& bias_px, const MatchSettings& settings, const GreyMap& greys) {
    FlowVector vector;
    vector.at_px = corner_px.cast<double>().array() + (block_px - 1) / 2.0;
    const SearchRange range = clipped_range(corner_px, bias_px, newer);
    if (range.empty() || !contains_block(reference, corner_px)) return vector;
    const Eigen::Vector2i at = corner_px + bias_px;
    const BlockMatch match =
        match_of(reference.row(corner_px.y()) + corner_px.x(), reference.stride_bytes,
                 newer.row(at.y()) + at.x(), newer.stride_bytes, range, settings.kernel->match, greys);
    vector.flow_px = bias_px.cast<double>() + refined_offset_px(match, settings.subpixel);
    vector.sigma_px = sigma_px_of(match);
    vector.confidence = confidence_of(match);
    vector.valid = true;
    return vector;
}

}  // namespace

SearchRange clipped_range(const Eigen::Vector2i& corner_px, const Eigen::Vector2i& bias_px,
                          const ImageView& image) {
    const auto at = displaced(corner_px, bias_px);
    const auto low = [](std::int64_t at_px) {
        return static_cast<int>(std::clamp<std::int64_t>(-at_px, search_min, search_max + 1));
    };
    const auto high = [](std::int64_t at_px, int size_px) {
        return static_cast<int>(
            std::clamp<std::int64_t>(size_px - block_px - at_px, search_min - 1, search_max));
    };
    return {low(at.x()), high(at.x(), image.width_px), low(at.y()), high(at.y(), image.height_px)};
}

void match_blocks(const ImageView& reference, const ImageView& newer, const BlockLayout& layout,
                  const std::vector<Eigen::Vector2i>& bias_px, const MatchSettings& settings,
                  std::vector<FlowVector>& vectors) {
    vectors.resize(layout.size());
    const GreyMap greys(settings.brightness);
    const int n = static_cast<int>(layout.size());
#pragma omp parallel for num_threads(settings.threads) schedule(static) if (settings.threads > 1)
    for (int i = 0; i < n; ++i)
        vectors[i] = match_one(reference, newer, layout.corner_px[i], bias_px[i], settings, greys);
}

}  // namespace flownav::flow
