// vdbpsadbw computes, for each of eight groups of 8 bytes, the sums of absolute differences of 4 pixels of
// the block at 4 places of the window: 32 sums of 4 pixels per instruction.
#include <immintrin.h>

#include "summary.h"
#include "units.h"

namespace flownav::flow::kernels::avx512bw {
namespace {

/// Immediates of vdbpsadbw: the 8-byte groups of a 16-byte piece from bytes 0 and 4, or from bytes 4 and 8.
constexpr int from_first_quad = 0b10'01'01'00;
constexpr int from_second_quad = 0b11'10'10'01;

/// Each row of the window as the 16-byte pieces from bytes 0, 8, 8 and 16. The lower half holds all 16 places
/// of two quads of the block, the upper half those of the other two.
struct alignas(64) Pieces {
    __m512i row[reached_px];
};

void cut(const uint8_t* window, ptrdiff_t stride, Pieces& pieces) {
    const __m512i order = _mm512_setr_epi64(0, 1, 1, 2, 1, 2, 2, 3);
    constexpr __mmask32 legal = 0x7FFFFFFF;  // the 32nd byte may lie outside the image's memory
    for (int v = 0; v < reached_px; ++v) {
        const __m256i bytes = _mm256_maskz_loadu_epi8(legal, window + v * stride);
        pieces.row[v] = _mm512_permutexvar_epi64(order, _mm512_castsi256_si512(bytes));
    }
}

/// Broadcasts 4 pixels of the block to the lower half and 4 others to the upper half.
__m512i quads(const uint8_t* lower, const uint8_t* upper) {
    return _mm512_inserti64x4(_mm512_broadcastd_epi32(_mm_loadu_si32(lower)),
                              _mm256_broadcastd_epi32(_mm_loadu_si32(upper)), 1);
}

}  // namespace

void surface_of(const uint8_t* block, ptrdiff_t block_stride, const uint8_t* window, ptrdiff_t window_stride,
                Surface& surface) {
    Pieces pieces;
    cut(window, window_stride, pieces);
    __m512i sums[side];
    for (__m512i& sum : sums) sum = _mm512_setzero_si512();
    for (int v = 0; v < side; ++v) {
        const uint8_t* pixels = block + v * block_stride;
        const __m512i first = quads(pixels, pixels + 8);
        const __m512i second = quads(pixels + 4, pixels + 12);
#pragma GCC unroll 16
        for (int nu = 0; nu < side; ++nu) {
            const __m512i row = pieces.row[v + nu];
            const __m512i more = _mm512_add_epi16(_mm512_dbsad_epu8(first, row, from_first_quad),
                                                  _mm512_dbsad_epu8(second, row, from_second_quad));
            sums[nu] = _mm512_add_epi16(sums[nu], more);
        }
    }
    for (int nu = 0; nu < side; nu += 2) {
        const __m512i lower = _mm512_shuffle_i64x2(sums[nu], sums[nu + 1], 0b01'00'01'00);
        const __m512i upper = _mm512_shuffle_i64x2(sums[nu], sums[nu + 1], 0b11'10'11'10);
        _mm512_store_si512(&surface.cost[nu * side], _mm512_add_epi16(lower, upper));
    }
}

Summary summary_of(const Surface& surface) {
    return summarised(surface);
}

}  // namespace flownav::flow::kernels::avx512bw
