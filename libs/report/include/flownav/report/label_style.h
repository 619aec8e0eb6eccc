#pragma once
#include <array>

#include "flownav/core/flow_vector.h"
#include "flownav/report/palette.h"

namespace flownav::report {

/// Colour and word of a label, the same in every picture and page.
struct LabelStyle {
    BlockLabel label;
    Colour colour;
    const char* name;
};

/// In the order they are drawn, the most important last. Unplaced blocks are not drawn.
const std::array<LabelStyle, 7>& label_styles();

/// The style of a label; null for BlockLabel::Unplaced.
const LabelStyle* style_of(BlockLabel label);

}  // namespace flownav::report
