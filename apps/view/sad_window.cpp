#include "sad_window.h"

#include <algorithm>
#include <cstdlib>

#include "flownav/flow/match_blocks.h"

namespace flownav::view {

namespace {

using Eigen::Vector2i;

constexpr double half_block_px = (flow::block_px - 1) / 2.0;

Vector2i corner_of(const pipeline::BlockRecord& block) {
    return (block.vector.at_px.array() - half_block_px).round().cast<int>();
}

Vector2i bias_of(const pipeline::BlockRecord& block) {
    return block.predicted_px.array().round().cast<int>();
}

/// Brightness over all blocks, as the matcher computes it.
flow::Brightness brightness_of(const Frame& frame, const flow::FlowParams& params) {
    if (params.brightness == flow::BrightnessModel::Constant) return {};
    flow::BlockLayout layout;
    std::vector<Vector2i> bias_px;
    for (const auto& block : frame.step.blocks) {
        layout.corner_px.push_back(corner_of(block));
        layout.centre_px.push_back(block.vector.at_px);
        layout.in_ground_window.push_back(block.in_ground_window ? 1 : 0);
        bias_px.push_back(bias_of(block));
    }
    flow::GreySums sums;
    return flow::compare_brightness(frame.reference->image, frame.field.image, layout, bias_px, sums);
}

/// Offset of the cost that `summarise` reports as the second minimum; the first one in raster order.
Vector2i second_offset(const flow::SadSurface& surface, const flow::SearchRange& range,
                       const flow::BlockMatch& match) {
    for (int nu = range.nu_min; nu <= range.nu_max; ++nu) {
        for (int mu = range.mu_min; mu <= range.mu_max; ++mu) {
            const bool distinct =
                std::max(std::abs(mu - match.mu), std::abs(nu - match.nu)) >= flow::distinct_px;
            const auto at =
                static_cast<std::size_t>((nu - flow::search_min) * flow::search_px + mu - flow::search_min);
            if (distinct && surface.at(at) == match.second) return {mu, nu};
        }
    }
    return {match.mu, match.nu};
}

}  // namespace

std::optional<SadWindow> sad_window(const Frame& frame, std::size_t block, const flow::FlowParams& params) {
    const bool compared = frame.reference && frame.step.image_of_cycle > 0;
    if (!compared || block >= frame.step.blocks.size()) return std::nullopt;
    SadWindow window;
    const pipeline::BlockRecord& record = frame.step.blocks[block];
    window.corner_px = corner_of(record);
    window.bias_px = bias_of(record);
    const ImageView& newer = frame.field.image;
    window.range = flow::clipped_range(window.corner_px, window.bias_px, newer);
    if (window.range.empty()) return std::nullopt;
    window.brightness = brightness_of(frame, params);
    const flow::GreyTable greys = flow::grey_table(window.brightness);
    std::array<std::uint8_t, std::size_t{flow::block_px} * flow::block_px> pixels{};
    for (int v = 0; v < flow::block_px; ++v) {
        for (int u = 0; u < flow::block_px; ++u) {
            pixels.at(v * flow::block_px + u) =
                greys[frame.reference->image.at(window.corner_px.x() + u, window.corner_px.y() + v)];
        }
    }
    const Vector2i at = window.corner_px + window.bias_px;
    window.surface = flow::sad_surface(pixels.data(), flow::block_px, newer.row(at.y()) + at.x(),
                                       newer.stride_bytes, window.range);
    window.match = flow::summarise(window.surface, window.range);
    window.second = second_offset(window.surface, window.range, window.match);
    return window;
}

}  // namespace flownav::view
