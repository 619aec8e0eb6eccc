// vmpsadbw computes, in each half of a register, the sums of absolute differences of 4 pixels of the block at
// 8 places of the window: 16 sums of 4 pixels per instruction.
#include <immintrin.h>

#include "summary.h"
#include "units.h"

namespace flownav::flow::kernels::avx2 {
namespace {

/// Immediates of vmpsadbw: pixels 0-3, 4-7, 8-11 or 12-15 of the block, and the window from byte 0 or 4 of
/// each half.
constexpr int quad_0 = 0b000'000, quad_1 = 0b101'101, quad_2 = 0b010'010, quad_3 = 0b111'111;

/// Each row of the window as 16-byte pieces: those from bytes 0 and 8 hold all 16 places of the first two
/// quads of the block, those from bytes 8 and 16 the places of the last two.
struct alignas(64) Pieces {
    __m256i row[reached_px][2];
};

__m128i load(const uint8_t* from) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

/// Cuts a row of 32 bytes, the last of which is not used, into pieces.
void cut(const __m256i& row, __m256i (&pieces)[2]) {
    pieces[0] = _mm256_permute4x64_epi64(row, 0b10'01'01'00);
    pieces[1] = _mm256_permute4x64_epi64(row, 0b11'10'10'01);
}

void cut(const uint8_t* window, ptrdiff_t stride, Pieces& pieces) {
    constexpr int last = reached_px - 1;
    for (int v = 0; v < last; ++v)
        cut(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(window + v * stride)), pieces.row[v]);
    // The byte after the last row may lie outside the image's memory.
    const __m128i end = _mm_srli_si128(load(window + last * stride + 15), 1);
    cut(_mm256_set_m128i(end, load(window + last * stride)), pieces.row[last]);
}

/// Sums eight rows of offsets, as many as fit into the registers.
void eight_rows(const uint8_t* block, ptrdiff_t stride, const __m256i (*pieces)[2], uint16_t* costs) {
    __m256i sums[8];
    for (__m256i& sum : sums) sum = _mm256_setzero_si256();
    for (int v = 0; v < side; ++v) {
        const __m256i pixels = _mm256_broadcastsi128_si256(load(block + v * stride));
#pragma GCC unroll 8
        for (int nu = 0; nu < 8; ++nu) {
            const __m256i left = pieces[v + nu][0];
            const __m256i right = pieces[v + nu][1];
            const __m256i half = _mm256_add_epi16(_mm256_mpsadbw_epu8(left, pixels, quad_0),
                                                  _mm256_mpsadbw_epu8(left, pixels, quad_1));
            const __m256i other = _mm256_add_epi16(_mm256_mpsadbw_epu8(right, pixels, quad_2),
                                                   _mm256_mpsadbw_epu8(right, pixels, quad_3));
            sums[nu] = _mm256_add_epi16(sums[nu], _mm256_add_epi16(half, other));
        }
    }
    for (ptrdiff_t nu = 0; nu < 8; ++nu)
        _mm256_store_si256(reinterpret_cast<__m256i*>(costs + nu * side), sums[nu]);
}

}  // namespace

void surface_of(const uint8_t* block, ptrdiff_t block_stride, const uint8_t* window, ptrdiff_t window_stride,
                Surface& surface) {
    Pieces pieces;
    cut(window, window_stride, pieces);
    eight_rows(block, block_stride, pieces.row, surface.cost);
    eight_rows(block, block_stride, pieces.row + 8, surface.cost + ptrdiff_t{8} * side);
}

Summary summary_of(const Surface& surface) {
    return summarised(surface);
}

}  // namespace flownav::flow::kernels::avx2
