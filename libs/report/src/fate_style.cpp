#include "flownav/report/fate_style.h"

#include <algorithm>

namespace flownav {

const std::array<FateStyle, 7>& fate_styles() {
    static const std::array<FateStyle, 7> all = {{
        {BlockFate::Sifted, {150, 150, 150}, "ambiguous"},
        {BlockFate::Unjudged, {233, 180, 86}, "unjudged"},
        {BlockFate::Ground, {115, 158, 0}, "ground"},
        {BlockFate::Eliminated, {167, 121, 204}, "eliminated"},
        {BlockFate::Unsupported, {66, 228, 240}, "unsupported"},
        {BlockFate::Moving, {178, 114, 0}, "moving"},
        {BlockFate::Obstacle, {0, 94, 213}, "obstacle"},
    }};
    return all;
}

const FateStyle* style_of(BlockFate fate) {
    const auto& all = fate_styles();
    const auto same = [fate](const FateStyle& style) { return style.fate == fate; };
    const auto found = std::find_if(all.begin(), all.end(), same);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace flownav
