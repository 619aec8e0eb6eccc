// Plain C++ that every compiler can vectorise.
#include "summary.h"
#include "units.h"

namespace flownav::flow::kernels::portable {
namespace {

int sad(const uint8_t* block, const uint8_t* other, ptrdiff_t stride) {
    int sum = 0;
    for (ptrdiff_t v = 0; v < side; ++v) {
        const uint8_t* p = block + v * side;
        const uint8_t* q = other + v * stride;
        for (int u = 0; u < side; ++u) sum += __builtin_abs(p[u] - q[u]);
    }
    return sum;
}

}  // namespace

void surface_of(const uint8_t* block, ptrdiff_t block_stride, const uint8_t* window, ptrdiff_t window_stride,
                Surface& surface) {
    uint8_t packed[side * side];
    for (ptrdiff_t v = 0; v < side; ++v) {
        for (int u = 0; u < side; ++u) packed[v * side + u] = block[v * block_stride + u];
    }
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            // Eq. (2)
            surface.cost[row * side + column] =
                static_cast<uint16_t>(sad(packed, window + row * window_stride + column, window_stride));
        }
    }
}

Summary summary_of(const Surface& surface) {
    return summarised(surface);
}

}  // namespace flownav::flow::kernels::portable
