#include "kernel_portable.h"

#include <cstdlib>

namespace flownav {
namespace {

using Block = std::array<std::uint8_t, std::size_t{block_px} * block_px>;

Block gather(const std::uint8_t* block, std::ptrdiff_t stride) {
    Block packed;
    for (int v = 0; v < block_px; ++v) {
        for (int u = 0; u < block_px; ++u) packed[v * block_px + u] = block[v * stride + u];
    }
    return packed;
}

int sad_of(const Block& block, const std::uint8_t* other, std::ptrdiff_t stride) {
    int sum = 0;
    for (int v = 0; v < block_px; ++v) {
        const std::uint8_t* p = block.data() + std::ptrdiff_t{v} * block_px;
        const std::uint8_t* q = other + v * stride;
        for (int u = 0; u < block_px; ++u) sum += std::abs(p[u] - q[u]);
    }
    return sum;
}

}  // namespace

SadSurface sad_surface(const std::uint8_t* block, std::ptrdiff_t block_stride, const std::uint8_t* window,
                       std::ptrdiff_t window_stride, const SearchRange& range) {
    const Block packed = gather(block, block_stride);
    SadSurface surface;
    surface.fill(no_cost);
    for (int nu = range.nu_min; nu <= range.nu_max; ++nu) {
        for (int mu = range.mu_min; mu <= range.mu_max; ++mu) {
            // Eq. (2)
            surface[(nu - search_min) * search_px + (mu - search_min)] =
                static_cast<std::uint16_t>(sad_of(packed, window + nu * window_stride + mu, window_stride));
        }
    }
    return surface;
}

BlockMatch match_portable(const std::uint8_t* block, std::ptrdiff_t block_stride, const std::uint8_t* window,
                          std::ptrdiff_t window_stride, const SearchRange& range) {
    return summarise(sad_surface(block, block_stride, window, window_stride, range), range);
}

}  // namespace flownav
