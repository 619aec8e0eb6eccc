#pragma once
// Sums and brightness mapping of a block's pixels: SSE2 code for every x86-64 processor, plain C++ for
// others.
#include <array>
#include <cstddef>
#include <cstdint>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "flownav/flow/brightness.h"
#include "flownav/flow/kernel.h"

namespace flownav::flow {

/// Sums over the pixels of one 16x16 block.
struct BlockSums {
    std::int32_t greys = 0, squares = 0;
};

/// The pixels of a block, row by row.
struct GreyBlock {
    alignas(16) std::array<std::uint8_t, std::size_t{block_px} * block_px> pixels;
};

#ifdef __SSE2__

/// Sums the grey levels of a block and their squares. `block`: its top left pixel.
inline BlockSums sums_of(const std::uint8_t* block, std::ptrdiff_t stride) {
    const __m128i zero = _mm_setzero_si128();
    __m128i greys = zero;
    __m128i squares = zero;
    for (std::ptrdiff_t v = 0; v < block_px; ++v) {
        const __m128i row = _mm_loadu_si128(reinterpret_cast<const __m128i*>(block + v * stride));
        const __m128i left = _mm_unpacklo_epi8(row, zero);
        const __m128i right = _mm_unpackhi_epi8(row, zero);
        const __m128i more = _mm_add_epi32(_mm_madd_epi16(left, left), _mm_madd_epi16(right, right));
        greys = _mm_add_epi32(greys, _mm_sad_epu8(row, zero));
        squares = _mm_add_epi32(squares, more);
    }
    greys = _mm_add_epi32(greys, _mm_unpackhi_epi64(greys, greys));
    squares = _mm_add_epi32(squares, _mm_unpackhi_epi64(squares, squares));
    squares = _mm_add_epi32(squares, _mm_shuffle_epi32(squares, 1));
    return {_mm_cvtsi128_si32(greys), _mm_cvtsi128_si32(squares)};
}

/// Returns the block with its brightness mapped to that of the newer image.
inline GreyBlock shown_block(const std::uint8_t* block, std::ptrdiff_t stride, const GreyMap& map) {
    const __m128i zero = _mm_setzero_si128();
    const __m128i gain = _mm_set1_epi16(map.gain);
    const __m128i offset = _mm_set1_epi16(map.offset);
    const auto shown = [&](const __m128i& greys) {
        const __m128i scaled = _mm_mulhi_epi16(_mm_slli_epi16(greys, 7), gain);
        return _mm_srai_epi16(_mm_add_epi16(scaled, offset), 5);
    };
    GreyBlock result;
    for (std::ptrdiff_t v = 0; v < block_px; ++v) {
        const __m128i row = _mm_loadu_si128(reinterpret_cast<const __m128i*>(block + v * stride));
        const __m128i greys =
            _mm_packus_epi16(shown(_mm_unpacklo_epi8(row, zero)), shown(_mm_unpackhi_epi8(row, zero)));
        _mm_store_si128(reinterpret_cast<__m128i*>(result.pixels.data() + v * block_px), greys);
    }
    return result;
}

#else

inline BlockSums sums_of(const std::uint8_t* block, std::ptrdiff_t stride) {
    BlockSums s;
    for (std::ptrdiff_t v = 0; v < block_px; ++v) {
        for (int u = 0; u < block_px; ++u) {
            const std::int32_t grey = block[v * stride + u];
            s.greys += grey;
            s.squares += grey * grey;
        }
    }
    return s;
}

inline GreyBlock shown_block(const std::uint8_t* block, std::ptrdiff_t stride, const GreyMap& map) {
    GreyBlock result;
    for (std::ptrdiff_t v = 0; v < block_px; ++v)
        for (int u = 0; u < block_px; ++u) result.pixels[v * block_px + u] = map(block[v * stride + u]);
    return result;
}

#endif

}  // namespace flownav::flow
