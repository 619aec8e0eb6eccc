#pragma once
#include <array>
#include <opencv2/core/types.hpp>

#include "flownav/core/flow_vector.h"

namespace flownav::report {

/// How a label looks in every picture: a colour of the palette of Okabe and Ito, which colour-blind eyes can
/// tell apart, and a word for the legend.
struct LabelStyle {
    BlockLabel label;
    cv::Scalar colour;  ///< BGR
    const char* name;
};

/// In the order they are drawn: what matters most lies on top. Unplaced blocks are not drawn.
const std::array<LabelStyle, 7>& label_styles();

/// The style of a label; null for BlockLabel::Unplaced.
const LabelStyle* style_of(BlockLabel label);

}  // namespace flownav::report
