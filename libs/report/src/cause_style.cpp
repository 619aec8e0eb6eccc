#include "flownav/report/cause_style.h"

#include <algorithm>

namespace flownav::report {

const std::array<CauseStyle, 4>& cause_styles() {
    static const std::array<CauseStyle, 4> all = {{
        {BeamCause::Votes, palette::vermilion, "contact"},
        {BeamCause::Wall, palette::sky_blue, "wall"},
        {BeamCause::Drop, palette::yellow, "drop"},
        {BeamCause::Blocks, palette::orange, "blocks"},
    }};
    return all;
}

Colour colour_of(BeamCause cause) {
    const auto& all = cause_styles();
    const auto same = [cause](const CauseStyle& style) { return style.cause == cause; };
    const auto found = std::find_if(all.begin(), all.end(), same);
    return found == all.end() ? palette::grey : found->colour;
}

}  // namespace flownav::report
