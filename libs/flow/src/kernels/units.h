#pragma once
// What every kernel offers to kernel.cpp. Each is compiled for its own instruction set: nothing inline may be
// shared between them, or the linker could pick a copy that this processor does not understand. So: plain
// data and declarations only; <cstddef> brings inline functions.
#include <stddef.h>  // NOLINT(modernize-deprecated-headers)
#include <stdint.h>  // NOLINT(modernize-deprecated-headers)

namespace flownav::flow::kernels {

constexpr int side = 16;                  ///< of the block, and of the window of offsets
constexpr int offsets = side * side;      ///< in raster order: nu is the row, mu the column
constexpr int reached_px = 2 * side - 1;  ///< side of the part of the image that the window reaches

/// Costs of all offsets; 65535 where there is none.
struct alignas(64) Surface {
    uint16_t cost[offsets];
};

struct Summary {
    uint16_t minimum;
    uint16_t second;  ///< smallest cost 3 or more away from the minimum
    int index;        ///< of the minimum
    uint32_t sum;     ///< of all costs, with those that are none
};

/// Constants of a summary. Rows and columns of ones are 65535, the others 0.
struct SummaryTables {
    alignas(64) uint16_t rank[offsets];              ///< place of an offset in the order of the tie-break
    alignas(64) uint16_t near_rows[2 * side][side];  ///< row (side - 1 + r - r0) is ones when |r - r0| < 3
    alignas(64) uint16_t near_columns[side][side];   ///< row c0 has ones where |c - c0| < 3
    uint8_t order[offsets];                          ///< the offset of a rank
};
extern const SummaryTables summary_tables;

/// Sums of absolute differences of a block with all places of the window: `window` is the first of 31x31
/// pixels.
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
