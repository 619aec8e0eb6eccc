#pragma once
// Interface of every kernel to kernel.cpp. Each kernel is compiled for its own instruction set, so the units
// must not share inline functions: the linker could keep a copy that this processor cannot run. This header
// therefore holds plain data and declarations only and avoids <cstddef>, which has inline functions.
#include <stddef.h>  // NOLINT(modernize-deprecated-headers)
#include <stdint.h>  // NOLINT(modernize-deprecated-headers)

namespace flownav::flow::kernels {

constexpr int side = 16;              ///< side of the block, and of the window of offsets
constexpr int offsets = side * side;  ///< number of offsets, in raster order: nu is the row, mu the column
constexpr int reached_px = 2 * side - 1;  ///< side of the part of the image that the search reads

/// Costs of all offsets; 65535 outside the search range.
struct alignas(64) Surface {
    uint16_t cost[offsets];
};

struct Summary {
    uint16_t minimum;
    uint16_t second;  ///< smallest cost at Chebyshev distance 3 or more from the minimum
    int index;        ///< index of the minimum
    uint32_t sum;     ///< sum of all costs, including those of 65535
};

/// Constant tables of a summary. "Ones" are 65535, all other elements of near_rows and near_columns are 0.
struct SummaryTables {
    alignas(64) uint16_t rank[offsets];              ///< rank of an offset in the tie-break
    alignas(64) uint16_t near_rows[2 * side][side];  ///< row side - 1 + r - r0 is ones when |r - r0| < 3
    alignas(64) uint16_t near_columns[side][side];   ///< row c0 has ones where |c - c0| < 3
    uint8_t order[offsets];                          ///< index of the offset with a rank
};
extern const SummaryTables summary_tables;

/// Computes the sums of absolute differences of a block at all places of the window. `window` is the first of
/// 31x31 pixels.
using SurfaceFunction = void (*)(const uint8_t* block, ptrdiff_t block_stride, const uint8_t* window,
                                 ptrdiff_t window_stride, Surface& surface);
using SummaryFunction = Summary (*)(const Surface& surface);

#define FLOWNAV_KERNEL_UNIT(name)                                                        \
    namespace name {                                                                     \
    void surface_of(const uint8_t* block, ptrdiff_t block_stride, const uint8_t* window, \
                    ptrdiff_t window_stride, Surface& surface);                          \
    Summary summary_of(const Surface& surface);                                          \
    }
FLOWNAV_KERNEL_UNIT(portable)
FLOWNAV_KERNEL_UNIT(sse41)
FLOWNAV_KERNEL_UNIT(avx2)
FLOWNAV_KERNEL_UNIT(avx512bw)
FLOWNAV_KERNEL_UNIT(neon)
#undef FLOWNAV_KERNEL_UNIT

}  // namespace flownav::flow::kernels
