#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "flownav/core/camera_model.h"
#include "flownav/flow/params.h"

namespace flownav::flow {

constexpr int neighbours_max = 8;
constexpr int ground_window_min = 12;  ///< smallest number of blocks placed in the ground window

/// Positions of the blocks, equal for every field of a camera.
struct BlockLayout {
    std::vector<Eigen::Vector2i> corner_px;  ///< top left pixel of each 16x16 block
    std::vector<Eigen::Vector2d> centre_px;  ///< corner_px + 7.5
    std::vector<Eigen::Vector2d> centre;     ///< centre_px on the reference's normalised plane
    std::vector<char> in_ground_window;      ///< 1: the block's flow measures the speed
    /// Indices of the nearest other blocks of each block, then -1.
    std::vector<std::array<int, neighbours_max>> neighbours;

    std::size_t size() const { return corner_px.size(); }
};

/// Places `params.blocks` blocks about uniformly on the ground, hence densely toward the horizon: none where
/// |e| < params.focus_exclusion, at least 12 in the ground window. Deterministic: uses a low-discrepancy
/// sequence. Empty when the image is too small for a block or lies wholly in the excluded cone.
BlockLayout place_blocks(const RayMapper& mapper, const FlowParams& params);

/// Sets layout.centre for another reference, whose parity or camera pose differs slightly.
void set_reference(BlockLayout& layout, const RayMapper& reference);

/// Returns every nth block of a layout, without neighbours, for coarse searches.
BlockLayout every_nth(const BlockLayout& layout, std::size_t n);

}  // namespace flownav::flow
