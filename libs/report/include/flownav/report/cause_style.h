#pragma once
#include <array>

#include "flownav/core/virtual_scan.h"
#include "flownav/report/palette.h"

namespace flownav::report {

/// Colour and word of the cause of a contact, the same in every picture and page.
struct CauseStyle {
    BeamCause cause;
    Colour colour;
    const char* name;
};

/// In the order of legends: all causes but BeamCause::None.
const std::array<CauseStyle, 4>& cause_styles();

Colour colour_of(BeamCause cause);

/// Colour of floor that the contact scan confirmed.
constexpr Colour confirmed_floor = palette::green;

}  // namespace flownav::report
