#include "flownav/report/label_style.h"

#include <algorithm>

namespace flownav::report {

const std::array<LabelStyle, 7>& label_styles() {
    static const std::array<LabelStyle, 7> all = {{
        {BlockLabel::Sifted, {150, 150, 150}, "ambiguous"},
        {BlockLabel::Unjudged, {233, 180, 86}, "unjudged"},
        {BlockLabel::Ground, {115, 158, 0}, "ground"},
        {BlockLabel::Eliminated, {167, 121, 204}, "eliminated"},
        {BlockLabel::Unsupported, {66, 228, 240}, "unsupported"},
        {BlockLabel::Moving, {178, 114, 0}, "moving"},
        {BlockLabel::Obstacle, {0, 94, 213}, "obstacle"},
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
