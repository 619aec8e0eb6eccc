#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flownav::flow {

constexpr int block_px = 16;    ///< edge of the reference block
constexpr int search_min = -8;  ///< Eq. (2): mu, nu in search_min .. search_max
constexpr int search_max = 7;
constexpr int search_px = search_max - search_min + 1;
constexpr int distinct_px = 3;  ///< smallest Chebyshev distance of a distinct second minimum

/// Offsets (mu, nu) to search, both ends included: the whole window, or the part inside the image.
struct SearchRange {
    int mu_min = search_min;
    int mu_max = search_max;
    int nu_min = search_min;
    int nu_max = search_max;

    bool empty() const { return mu_min > mu_max || nu_min > nu_max; }
};

/// Cost of every offset, row by row (nu), for one block. Offsets outside the range hold `no_cost`.
constexpr std::uint16_t no_cost = 0xFFFF;  // the largest possible SAD is 16 * 16 * 255 = 65280
constexpr std::size_t search_offsets = std::size_t{search_px} * search_px;
using SadSurface = std::array<std::uint16_t, search_offsets>;

/// Result of matching one block, as a motion estimation processor reports it.
struct BlockMatch {
    std::uint16_t minimum = no_cost;
    std::uint16_t second = no_cost;  ///< smallest cost at distinct_px or more from the minimum; no_cost: none
    std::uint32_t sum = 0;           ///< sum of all costs in the range
    int mu = 0;                      ///< offset of the minimum, > 0 to the right
    int nu = 0;                      ///< offset of the minimum, > 0 down
    std::uint16_t left = no_cost, right = no_cost, above = no_cost,
                  below = no_cost;  ///< neighbour costs
};

/// Matches one 16x16 block. `block` is its top left pixel in the reference, `window` the pixel at offset (0,
/// 0) in the newer image; every offset of `range` must lie inside the image. Never allocates.
using MatchKernel = BlockMatch (*)(const std::uint8_t* block, std::ptrdiff_t block_stride,
                                   const std::uint8_t* window, std::ptrdiff_t window_stride,
                                   const SearchRange& range);

struct KernelEntry {
    const char* name;
    bool (*supported)();  ///< true when this processor can run it
    MatchKernel match;
};

/// All kernels, fastest first. All give bit-identical results.
const std::vector<KernelEntry>& kernel_table();

/// Returns the kernel of that name; an empty name selects the first supported one. Throws std::runtime_error
/// when the kernel is unknown or this processor does not support it.
const KernelEntry& select_kernel(const std::string& name = {});

/// Returns the kernel named by the environment variable FLOWNAV_KERNEL, or the first supported one when it is
/// not set. Throws as select_kernel() does.
const KernelEntry& default_kernel();

/// Returns the whole cost surface of Eq. (2), for display and tests.
SadSurface sad_surface(const std::uint8_t* block, std::ptrdiff_t block_stride, const std::uint8_t* window,
                       std::ptrdiff_t window_stride, const SearchRange& range);

/// Returns minimum, second distinct minimum, sum and neighbours of a surface. Ties go to the smallest |(mu,
/// nu)|^2, then to the first in raster order; every kernel uses this tie-break.
BlockMatch summarise(const SadSurface& surface, const SearchRange& range);

}  // namespace flownav::flow
