#include "flownav/flow/kernel.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "kernels/units.h"

namespace flownav::flow {
namespace {

constexpr const char* kernel_variable = "FLOWNAV_KERNEL";

using kernels::reached_px;
using kernels::Surface;

constexpr bool same_shape =
    kernels::side == block_px && kernels::side == search_px && search_offsets == kernels::offsets;
static_assert(same_shape, "the kernels are made for this block and this window");

constexpr int index_of(int mu, int nu) {
    return (nu - search_min) * search_px + (mu - search_min);
}

bool is_whole(const SearchRange& r) {
    return r.mu_min == search_min && r.mu_max == search_max && r.nu_min == search_min &&
           r.nu_max == search_max;
}

/// Copy of the readable part of the window, padded with 0.
struct Padded {
    static constexpr int stride = reached_px + 1;
    std::uint8_t pixels[reached_px * stride] = {};

    Padded(const std::uint8_t* window, std::ptrdiff_t window_stride, const SearchRange& range) {
        const auto width = static_cast<std::size_t>(range.mu_max - range.mu_min) + block_px;
        for (std::ptrdiff_t v = range.nu_min; v < range.nu_max + block_px; ++v) {
            std::memcpy(pixels + (v - search_min) * stride + (range.mu_min - search_min),
                        window + v * window_stride + range.mu_min, width);
        }
    }
};

/// Sets the costs outside the range to no_cost. Returns their number.
int clear_outside(const SearchRange& range, std::uint16_t* cost) {
    for (int nu = search_min; nu <= search_max; ++nu) {
        std::uint16_t* row = cost + index_of(search_min, nu);
        const bool inside = nu >= range.nu_min && nu <= range.nu_max;
        std::fill(row, row + (inside ? range.mu_min - search_min : search_px), no_cost);
        if (inside) std::fill(row + (range.mu_max + 1 - search_min), row + search_px, no_cost);
    }
    const int inside = (range.mu_max + 1 - range.mu_min) * (range.nu_max + 1 - range.nu_min);
    return kernels::offsets - inside;
}

/// Fills a surface. Returns the number of offsets outside the range.
int fill(kernels::SurfaceFunction surface_of, const std::uint8_t* block, std::ptrdiff_t block_stride,
         const std::uint8_t* window, std::ptrdiff_t window_stride, const SearchRange& range,
         Surface& surface) {
    if (is_whole(range)) {
        const std::uint8_t* first = window + search_min * window_stride + search_min;
        surface_of(block, block_stride, first, window_stride, surface);
        return 0;
    }
    const Padded padded(window, window_stride, range);
    surface_of(block, block_stride, padded.pixels, Padded::stride, surface);
    return clear_outside(range, surface.cost);
}

BlockMatch match_of(const Surface& surface, const kernels::Summary& summary, int outside) {
    const int row = summary.index / search_px;
    const int column = summary.index % search_px;
    const std::uint16_t* at = surface.cost + summary.index;
    BlockMatch m;
    m.minimum = summary.minimum;
    m.second = summary.second;
    m.sum = summary.sum - static_cast<std::uint32_t>(outside) * no_cost;
    m.mu = column + search_min;
    m.nu = row + search_min;
    if (column > 0) m.left = at[-1];
    if (column < search_px - 1) m.right = at[1];
    if (row > 0) m.above = at[-search_px];
    if (row < search_px - 1) m.below = at[search_px];
    return m;
}

template <kernels::SurfaceFunction surface_of, kernels::SummaryFunction summary_of>
BlockMatch match(const std::uint8_t* block, std::ptrdiff_t block_stride, const std::uint8_t* window,
                 std::ptrdiff_t window_stride, const SearchRange& range) {
    Surface surface;
    const int outside = fill(surface_of, block, block_stride, window, window_stride, range, surface);
    return match_of(surface, summary_of(surface), outside);
}

#define FLOWNAV_KERNEL(unit, supported)                                                 \
    KernelEntry {                                                                       \
#unit, supported, match < kernels::unit::surface_of, kernels::unit::summary_of> \
    }

}  // namespace

const std::vector<KernelEntry>& kernel_table() {
    static const std::vector<KernelEntry> table = {
#ifdef FLOWNAV_X86_KERNELS
        FLOWNAV_KERNEL(
            avx512bw,
            [] { return __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl"); }),
        FLOWNAV_KERNEL(avx2, [] { return __builtin_cpu_supports("avx2") != 0; }),
        FLOWNAV_KERNEL(sse41, [] { return __builtin_cpu_supports("sse4.1") != 0; }),
#endif
#ifdef FLOWNAV_ARM_KERNELS
        FLOWNAV_KERNEL(neon, [] { return true; }),  // every AArch64 has it
#endif
        FLOWNAV_KERNEL(portable, [] { return true; })};
    return table;
}

const KernelEntry& select_kernel(const std::string& name) {
    const auto& table = kernel_table();
    const auto found = std::find_if(table.begin(), table.end(), [&](const KernelEntry& k) {
        return name.empty() ? k.supported() : name == k.name;
    });
    if (found == table.end()) {
        std::string known;
        for (const KernelEntry& k : table) known += std::string(known.empty() ? "" : ", ") + k.name;
        throw std::runtime_error("matching kernel '" + name + "' (" + kernel_variable +
                                 ") is unknown; known: " + known);
    }
    if (!found->supported()) {
        throw std::runtime_error("matching kernel '" + name + "' (" + kernel_variable +
                                 ") is not supported by this processor");
    }
    return *found;
}

const KernelEntry& default_kernel() {
    const char* name = std::getenv(kernel_variable);
    return select_kernel(name == nullptr ? "" : name);
}

SadSurface sad_surface(const std::uint8_t* block, std::ptrdiff_t block_stride, const std::uint8_t* window,
                       std::ptrdiff_t window_stride, const SearchRange& range) {
    Surface aligned;
    fill(kernels::portable::surface_of, block, block_stride, window, window_stride, range, aligned);
    SadSurface surface;
    std::copy(std::begin(aligned.cost), std::end(aligned.cost), surface.begin());
    return surface;
}

BlockMatch summarise(const SadSurface& surface, const SearchRange& range) {
    Surface aligned;
    std::copy(surface.begin(), surface.end(), aligned.cost);
    const int outside = clear_outside(range, aligned.cost);
    return match_of(aligned, kernels::portable::summary_of(aligned), outside);
}

}  // namespace flownav::flow
