#include "flownav/report/label_style.h"

#include <algorithm>

namespace flownav::report {

const std::array<LabelStyle, 7>& label_styles() {
    static const std::array<LabelStyle, 7> all = {{
        {BlockLabel::Sifted, {150, 150, 150}, "ambiguous"},
        {BlockLabel::Unjudged, palette::sky_blue, "unjudged"},
        {BlockLabel::Ground, palette::green, "ground"},
        {BlockLabel::Eliminated, palette::purple, "eliminated"},
        {BlockLabel::Unsupported, palette::yellow, "unsupported"},
        {BlockLabel::Moving, palette::blue, "moving"},
        {BlockLabel::Obstacle, palette::vermilion, "obstacle"},
    }};
    return all;
}

const LabelStyle* style_of(BlockLabel label) {
    const auto& all = label_styles();
    const auto same = [label](const LabelStyle& style) { return style.label == label; };
    const auto found = std::find_if(all.begin(), all.end(), same);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace flownav::report
