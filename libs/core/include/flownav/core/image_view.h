#pragma once
#include <cstddef>
#include <cstdint>

namespace flownav {

/// Non-owning view of an 8-bit grey image; row v starts at data + v * stride_bytes.
struct ImageView {
    const std::uint8_t* data = nullptr;
    int width_px = 0;
    int height_px = 0;
    std::ptrdiff_t stride_bytes = 0;

    const std::uint8_t* row(int v) const { return data + v * stride_bytes; }
    std::uint8_t at(int u, int v) const { return row(v)[u]; }
    bool empty() const { return data == nullptr || width_px <= 0 || height_px <= 0; }
};

}  // namespace flownav
