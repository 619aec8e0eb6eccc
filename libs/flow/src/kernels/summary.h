#pragma once
// Summary of a cost surface, compiled in every unit for its own instruction set. Uses vectors of one row,
// which the compiler splits for smaller registers. All functions have internal linkage, see units.h.
#ifdef __SSE4_1__
#include <smmintrin.h>
#endif

#include "units.h"

namespace flownav::flow::kernels {
namespace {

using Row = uint16_t __attribute__((vector_size(side * sizeof(uint16_t)), may_alias));

inline const Row* rows(const uint16_t* costs) {
    return reinterpret_cast<const Row*>(costs);
}

inline void keep_smaller(Row& least, const Row& row) {
    least = row < least ? row : least;
}

using HalfRow = uint16_t __attribute__((vector_size(side)));

inline HalfRow lower(const Row& row) {
    return __builtin_shufflevector(row, row, 0, 1, 2, 3, 4, 5, 6, 7);
}

inline HalfRow upper(const Row& row) {
    return __builtin_shufflevector(row, row, 8, 9, 10, 11, 12, 13, 14, 15);
}

#ifdef __SSE4_1__
inline uint16_t least_of(const Row& row) {
    const auto least =
        _mm_min_epu16(reinterpret_cast<__m128i>(lower(row)), reinterpret_cast<__m128i>(upper(row)));
    return static_cast<uint16_t>(_mm_cvtsi128_si32(_mm_minpos_epu16(least)));
}

/// Returns the sum of low + 256 high; sums of two elements must fit into 15 bits.
inline uint32_t total(const Row& low, const Row& high) {
    const auto ones = reinterpret_cast<__m128i>(lower(low) + upper(low));
    const auto hundreds = reinterpret_cast<__m128i>(lower(high) + upper(high));
    const __m128i weights = _mm_set1_epi32(256 * 0x10000 + 1);
    __m128i sum = _mm_add_epi32(_mm_madd_epi16(_mm_unpacklo_epi16(ones, hundreds), weights),
                                _mm_madd_epi16(_mm_unpackhi_epi16(ones, hundreds), weights));
    sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0b01'00'11'10));
    sum = _mm_add_epi32(sum, _mm_shuffle_epi32(sum, 0b10'11'00'01));
    return static_cast<uint32_t>(_mm_cvtsi128_si32(sum));
}
#else
inline uint16_t least_of(const Row& row) {
    uint16_t least = row[0];
    for (int i = 1; i < side; ++i) least = row[i] < least ? row[i] : least;
    return least;
}

/// Returns the sum of low + 256 high.
inline uint32_t total(const Row& low, const Row& high) {
    uint32_t sum = 0;
    for (int i = 0; i < side; ++i) sum += low[i] + 256U * high[i];
    return sum;
}
#endif

inline Summary summarised(const Surface& surface) {
    const Row* const cost = rows(surface.cost);
    const Row* const rank = rows(summary_tables.rank);
    Row smallest = cost[0];
    Row low_bytes = cost[0] & 0xFF;  // the sums of low and of high bytes fit into 16 bits
    Row high_bytes = cost[0] >> 8;
    for (int nu = 1; nu < side; ++nu) {
        keep_smaller(smallest, cost[nu]);
        low_bytes += cost[nu] & 0xFF;
        high_bytes += cost[nu] >> 8;
    }
    const uint16_t minimum = least_of(smallest);
    Row first = rank[0] | Row(cost[0] != minimum);
    for (int nu = 1; nu < side; ++nu) keep_smaller(first, rank[nu] | Row(cost[nu] != minimum));
    const int index = summary_tables.order[least_of(first)];
    const Row* const near_rows = rows(summary_tables.near_rows[side - 1 - index / side]);
    const Row near_columns = *rows(summary_tables.near_columns[index % side]);
    Row others = cost[0] | (near_rows[0] & near_columns);
    for (int nu = 1; nu < side; ++nu) keep_smaller(others, cost[nu] | (near_rows[nu] & near_columns));
    return {minimum, least_of(others), index, total(low_bytes, high_bytes)};
}

}  // namespace
}  // namespace flownav::flow::kernels
