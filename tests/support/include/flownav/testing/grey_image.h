#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "flownav/core/image_view.h"

namespace flownav::testing {

/// An 8-bit grey image that owns its pixels, row after row without gaps.
struct GreyImage {
    int width_px = 0;
    int height_px = 0;
    std::vector<std::uint8_t> pixels;

    GreyImage() = default;
    GreyImage(int width, int height)
        : width_px(width),
          height_px(height),
          pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    std::uint8_t* row(int v) { return pixels.data() + static_cast<std::ptrdiff_t>(v) * width_px; }
    std::uint8_t at(int u, int v) const { return view().at(u, v); }
    ImageView view() const { return {pixels.data(), width_px, height_px, width_px}; }
};

}  // namespace flownav::testing
