// mpsadbw computes the sums of absolute differences of 4 pixels of the block at 8 places of the window.
#include <smmintrin.h>

#include "summary.h"
#include "units.h"

namespace flownav::flow::kernels::sse41 {
namespace {

/// Immediates of mpsadbw: pixels 0-3, 4-7, 8-11 or 12-15 of the block, and the window from byte 0 or 4.
constexpr int quad_0 = 0b000, quad_1 = 0b101, quad_2 = 0b010, quad_3 = 0b111;

/// Each row of the window as the 16-byte pieces from bytes 0, 8 and 16.
struct alignas(64) Pieces {
    __m128i row[reached_px][3];
};

__m128i load(const uint8_t* from) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

void cut(const uint8_t* window, ptrdiff_t stride, Pieces& pieces) {
    for (int v = 0; v < reached_px; ++v) {
        const uint8_t* row = window + v * stride;
        pieces.row[v][0] = load(row);
        pieces.row[v][1] = load(row + 8);
        pieces.row[v][2] = _mm_srli_si128(load(row + 15), 1);  // the 32nd byte may lie outside the image
    }
}

/// Sums eight rows of eight offsets, as many as fit into the registers.
void eight_rows(const uint8_t* block, ptrdiff_t stride, const __m128i (*pieces)[3], int half,
                uint16_t* costs) {
    __m128i sums[8];
    for (__m128i& sum : sums) sum = _mm_setzero_si128();
    for (int v = 0; v < side; ++v) {
        const __m128i pixels = load(block + v * stride);
#pragma GCC unroll 8
        for (int nu = 0; nu < 8; ++nu) {
            const __m128i left = pieces[v + nu][half];
            const __m128i right = pieces[v + nu][half + 1];
            const __m128i a =
                _mm_add_epi16(_mm_mpsadbw_epu8(left, pixels, quad_0), _mm_mpsadbw_epu8(left, pixels, quad_1));
            const __m128i b = _mm_add_epi16(_mm_mpsadbw_epu8(right, pixels, quad_2),
                                            _mm_mpsadbw_epu8(right, pixels, quad_3));
            sums[nu] = _mm_add_epi16(sums[nu], _mm_add_epi16(a, b));
        }
    }
    for (int nu = 0; nu < 8; ++nu) {
        _mm_store_si128(reinterpret_cast<__m128i*>(costs + nu * side + 8 * half), sums[nu]);
    }
}

}  // namespace

void surface_of(const uint8_t* block, ptrdiff_t block_stride, const uint8_t* window, ptrdiff_t window_stride,
                Surface& surface) {
    Pieces pieces;
    cut(window, window_stride, pieces);
    for (int nu = 0; nu < side; nu += 8) {
        for (int half = 0; half < 2; ++half)
            eight_rows(block, block_stride, pieces.row + nu, half, surface.cost + nu * side);
    }
}

Summary summary_of(const Surface& surface) {
    return summarised(surface);
}

}  // namespace flownav::flow::kernels::sse41
