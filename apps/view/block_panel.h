#pragma once
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sad_window.h"

namespace flownav::view {

/// Lists every number of a block's record, as "name  value unit" lines.
std::vector<std::string> block_lines(const Frame& frame, std::size_t index);

/// Draws the block under the mouse (8-bit BGR, `size`): its numbers, and its SAD surface with minimum and
/// second minimum marked. Without a block, shows a hint.
cv::Mat block_panel(const Frame& frame, std::optional<std::size_t> block,
                    const std::optional<SadWindow>& window, const cv::Size& size);

}  // namespace flownav::view
