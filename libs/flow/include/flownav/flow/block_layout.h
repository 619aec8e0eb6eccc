#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "flownav/core/camera_model.h"
#include "flownav/flow/params.h"

namespace flownav::flow {

constexpr int neighbours_max = 8;
constexpr int ground_window_min = 12;  ///< blocks placed in the ground window at the least

/// Where the blocks lie, the same for every field of a camera.
struct BlockLayout {
    std::vector<Eigen::Vector2i> corner_px;  ///< top left pixel of each 16x16 block
    std::vector<Eigen::Vector2d> centre_px;  ///< corner + 7.5
    std::vector<Eigen::Vector2d> centre;     ///< the same on the normalised plane of the reference
    std::vector<char> in_ground_window;      ///< 1: its flow measures the speed
    /// The nearest other blocks of each, -1 behind the last.
    std::vector<std::array<int, neighbours_max>> neighbours;

    std::size_t size() const { return corner_px.size(); }
};

/// Places `params.blocks` blocks about uniformly on the ground, therefore dense toward the horizon, none
/// inside the blind cone |e| < params.focus_exclusion, at least 12 in the ground window. Deterministic: a
/// low-discrepancy sequence, no random numbers. Empty when the image is too small for a block or lies in the
/// blind cone.
BlockLayout place_blocks(const RayMapper& mapper, const FlowParams& params);

/// For a reference whose rows lie, or whose camera looks, a little differently.
void set_reference(BlockLayout& layout, const RayMapper& reference);

/// Every nth block of a layout, without neighbours: for quick searches.
BlockLayout every_nth(const BlockLayout& layout, std::size_t n);

}  // namespace flownav::flow
