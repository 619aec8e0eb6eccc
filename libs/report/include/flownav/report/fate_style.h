#pragma once
#include <array>
#include <opencv2/core/types.hpp>

#include "flownav/core/flow_vector.h"

namespace flownav {

/// How a fate looks in every picture: a colour of the palette of Okabe and Ito, which colour-blind eyes can
/// tell apart, and a word for the legend.
struct FateStyle {
    BlockFate fate;
    cv::Scalar colour;  ///< BGR
    const char* label;
};

/// In the order they are drawn: what matters most lies on top. Unplaced blocks are not drawn.
const std::array<FateStyle, 7>& fate_styles();

/// The style of a fate; null for BlockFate::Unplaced.
const FateStyle* style_of(BlockFate fate);

}  // namespace flownav
