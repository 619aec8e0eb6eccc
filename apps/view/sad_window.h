#pragma once
#include <Eigen/Core>
#include <optional>

#include "flownav/flow/brightness.h"
#include "flownav/flow/kernel.h"
#include "flownav/flow/params.h"
#include "frame.h"

namespace flownav::view {

/// Matching costs of one block in one field: Eq. (2).
struct SadWindow {
    flow::SadSurface surface{};  ///< cost of each offset, row by row; no_cost outside the image
    flow::SearchRange range;     ///< offsets inside the image
    Eigen::Vector2i corner_px = Eigen::Vector2i::Zero();  ///< corner of the block in the reference
    Eigen::Vector2i bias_px = Eigen::Vector2i::Zero();  ///< centre of the window: the predicted flow, rounded
    Eigen::Vector2i second = Eigen::Vector2i::Zero();   ///< offset (mu, nu) of the second minimum
    flow::BlockMatch match;
    flow::Brightness brightness;  ///< of the newer field relative to the reference
};

/// Repeats the matching of a block of the frame. Empty when the field has no reference, or no offset of the
/// window lies inside the image.
std::optional<SadWindow> sad_window(const Frame& frame, std::size_t block, const flow::FlowParams& params);

}  // namespace flownav::view
