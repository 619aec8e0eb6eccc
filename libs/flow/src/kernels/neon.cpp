// uabd computes 16 absolute differences, uadalp adds them in pairs.
#include <arm_neon.h>

#include "summary.h"
#include "units.h"

namespace flownav::flow::kernels::neon {
namespace {

/// Sums over the rows of the block for 8 adjacent offsets, each in 8 parts of at most 8160.
struct Parts {
    uint16x8_t of[8];
};

template <int mu>
void add(const uint8x16_t& pixels, const uint8x16_t& left, const uint8x16_t& right, Parts& parts) {
    const uint8x16_t place = vextq_u8(left, right, mu);
    parts.of[mu] = vpadalq_u8(parts.of[mu], vabdq_u8(pixels, place));
}

/// Adds one row of the block. `end`: the window's bytes from 16 on, of which 7 are used.
void add_row(const uint8x16_t& pixels, const uint8x16_t& begin, const uint8x16_t& end, Parts& parts) {
    add<0>(pixels, begin, end, parts);
    add<1>(pixels, begin, end, parts);
    add<2>(pixels, begin, end, parts);
    add<3>(pixels, begin, end, parts);
    add<4>(pixels, begin, end, parts);
    add<5>(pixels, begin, end, parts);
    add<6>(pixels, begin, end, parts);
    add<7>(pixels, begin, end, parts);
}

uint16x8_t totals(const Parts& p) {
    const uint16x8_t a = vpaddq_u16(vpaddq_u16(p.of[0], p.of[1]), vpaddq_u16(p.of[2], p.of[3]));
    const uint16x8_t b = vpaddq_u16(vpaddq_u16(p.of[4], p.of[5]), vpaddq_u16(p.of[6], p.of[7]));
    return vpaddq_u16(a, b);
}

}  // namespace

void surface_of(const uint8_t* block, ptrdiff_t block_stride, const uint8_t* window, ptrdiff_t window_stride,
                Surface& surface) {
    const uint8x16_t none = vdupq_n_u8(0);
    for (int nu = 0; nu < side; ++nu) {
        Parts left, right;
        for (uint16x8_t& sum : left.of) sum = vdupq_n_u16(0);
        for (uint16x8_t& sum : right.of) sum = vdupq_n_u16(0);
        for (int v = 0; v < side; ++v) {
            const uint8x16_t pixels = vld1q_u8(block + v * block_stride);
            const uint8_t* row = window + (v + nu) * window_stride;
            const uint8x16_t begin = vld1q_u8(row);
            const uint8x16_t middle = vld1q_u8(row + 8);
            // The 32nd byte may lie outside the image's memory.
            const uint8x16_t end = vextq_u8(vld1q_u8(row + 15), none, 1);
            add_row(pixels, begin, end, left);
            add_row(pixels, middle, vextq_u8(end, none, 8), right);
        }
        vst1q_u16(&surface.cost[nu * side], totals(left));
        vst1q_u16(&surface.cost[nu * side + 8], totals(right));
    }
}

Summary summary_of(const Surface& surface) {
    return summarised(surface);
}

}  // namespace flownav::flow::kernels::neon
