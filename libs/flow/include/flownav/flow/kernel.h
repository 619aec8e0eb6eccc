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
constexpr int distinct_px = 3;  ///< Chebyshev distance from which a second minimum is another one

/// Offsets (mu, nu) that may be tried, both ends included: the whole window, or what the image border leaves.
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

/// What a motion estimation processor reports of one block.
struct BlockMatch {
    std::uint16_t minimum = no_cost;
    std::uint16_t second = no_cost;  ///< smallest cost at distinct_px or more from the minimum; no_cost: none
    std::uint32_t sum = 0;           ///< of all costs in the range
    int mu = 0;                      ///< offset of the minimum to the right
    int nu = 0;                      ///< and down
    std::uint16_t left = no_cost, right = no_cost, above = no_cost, below = no_cost;  ///< costs beside it
};

/// Matches one 16x16 block. `block` is its top left pixel in the reference, `window` the pixel at offset (0,
/// 0) in the newer image; every offset of `range` must lie inside the image. Never allocates.
using MatchKernel = BlockMatch (*)(const std::uint8_t* block, std::ptrdiff_t block_stride,
                                   const std::uint8_t* window, std::ptrdiff_t window_stride,
                                   const SearchRange& range);

struct KernelEntry {
    const char* name;
    bool (*supported)();  ///< by this processor
    MatchKernel match;
};

/// All kernels, fastest first. All give bit-identical results.
const std::vector<KernelEntry>& kernel_table();

/// The first supported kernel, or the one the name asks for. Throws std::runtime_error when that is unknown
/// or not supported here. An empty name asks for the best.
const KernelEntry& select_kernel(const std::string& name = {});

/// The kernel that the environment variable FLOWNAV_KERNEL names; the best one where it is not set. Throws
/// std::runtime_error as select_kernel() does.
const KernelEntry& default_kernel();

/// The whole surface of Eq. (2), for people who want to look at it.
SadSurface sad_surface(const std::uint8_t* block, std::ptrdiff_t block_stride, const std::uint8_t* window,
                       std::ptrdiff_t window_stride, const SearchRange& range);

/// Minimum, second distinct minimum, sum and neighbours of a surface. Ties go to the smallest |(mu, nu)|^2,
/// then to the first in raster order: the ONE tie-break of every kernel.
BlockMatch summarise(const SadSurface& surface, const SearchRange& range);

}  // namespace flownav::flow
