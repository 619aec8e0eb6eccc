// Every kernel gives the same result as the portable one on any input.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <random>

#include "flownav/flow/kernel.h"
#include "guarded_memory.h"

namespace flownav::flow {

void PrintTo(const KernelEntry& kernel, std::ostream* out) {
    *out << kernel.name;
}

namespace {

using testing::GuardedMemory;

constexpr int cases = 10000;
constexpr int margin_px = 24;  // margin of the image around the block
constexpr int image_px = block_px + 2 * margin_px;

/// An image at the very end (or beginning) of its memory.
struct Image {
    Image() : memory(4) {}

    void place(int new_stride, bool at_end) {
        stride = new_stride;
        const int bytes = (image_px - 1) * stride + image_px;
        pixels = at_end ? memory.end() - bytes : memory.begin();
    }
    std::uint8_t& at(int u, int v) { return pixels[v * stride + u]; }

    GuardedMemory memory;
    std::uint8_t* pixels = nullptr;
    int stride = image_px;
};

enum class Kind { Random, Constant, Ramp, Saturated, Smooth, Stripes, count };

void fill(Image& image, Kind kind, std::mt19937& random) {
    const int level = static_cast<int>(random() % 256);
    const int du = static_cast<int>(random() % 7) - 3;
    const int dv = static_cast<int>(random() % 7) - 3;
    for (int v = 0; v < image_px; ++v) {
        for (int u = 0; u < image_px; ++u) {
            int grey = 0;
            switch (kind) {
                case Kind::Random:
                    grey = static_cast<int>(random() % 256);
                    break;
                case Kind::Constant:
                    grey = level;
                    break;
                case Kind::Ramp:
                    grey = level + du * u + dv * v;
                    break;
                case Kind::Saturated:
                    grey = random() % 2 == 0 ? 0 : 255;
                    break;
                case Kind::Smooth:
                    grey = level + 40 * ((u * du + v * dv) % 16) / 16 + static_cast<int>(random() % 4);
                    break;
                default:
                    grey = (u * du + v * dv) % 8 < 4 ? 30 : 220;
            }
            image.at(u, v) = static_cast<std::uint8_t>(std::clamp(grey, 0, 255));
        }
    }
}

/// The whole window, or the part of it that an image border leaves.
SearchRange some_range(std::mt19937& random) {
    if (random() % 2 == 0) return {};
    const auto pick = [&] {
        const int a = search_min + static_cast<int>(random() % search_px);
        const int b = search_min + static_cast<int>(random() % search_px);
        return std::minmax({a, b});
    };
    const auto [mu_min, mu_max] = pick();
    const auto [nu_min, nu_max] = pick();
    return {mu_min, mu_max, nu_min, nu_max};
}

::testing::AssertionResult same(const BlockMatch& p, const BlockMatch& q) {
    const auto all = [](const BlockMatch& m) {
        return std::array<long, 9>{m.minimum, m.second, m.sum, m.mu, m.nu, m.left, m.right, m.above, m.below};
    };
    if (all(p) == all(q)) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << ::testing::PrintToString(all(p)) << " against " << ::testing::PrintToString(all(q));
}

class EveryKernel : public ::testing::TestWithParam<KernelEntry> {};

std::string name_of(const ::testing::TestParamInfo<KernelEntry>& info) {
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryKernel, ::testing::ValuesIn(kernel_table()), name_of);

TEST_P(EveryKernel, GivesWhatThePortableOneGives) {
    const KernelEntry& kernel = GetParam();
    if (!kernel.supported()) GTEST_SKIP() << "this processor has no " << kernel.name;
    const KernelEntry& portable = select_kernel("portable");
    std::mt19937 random(1);
    Image reference, newer;
    for (int i = 0; i < cases; ++i) {
        const bool at_end = random() % 2 == 0;
        reference.place(image_px + static_cast<int>(random() % 40), at_end);
        newer.place(image_px + static_cast<int>(random() % 40), at_end);
        fill(reference, static_cast<Kind>(random() % static_cast<int>(Kind::count)), random);
        if (random() % 4 == 0) {
            fill(newer, static_cast<Kind>(random() % static_cast<int>(Kind::count)), random);
        } else {  // the reference, moved
            const int du = static_cast<int>(random() % 16);
            for (int v = 0; v < image_px; ++v) {
                for (int u = 0; u < image_px; ++u)
                    newer.at(u, v) = reference.at(std::min(u + du, image_px - 1), v);
            }
        }
        const SearchRange range = some_range(random);
        // At the end of the memory the last window ends with the last pixel; at its beginning the first
        // window begins with the first pixel.
        const int edge = image_px - block_px;
        const int u = at_end ? edge - range.mu_max : -range.mu_min;
        const int v = at_end ? edge - range.nu_max : -range.nu_min;
        const std::uint8_t* block = at_end ? &reference.at(edge, edge) : &reference.at(0, 0);
        const std::uint8_t* window = newer.pixels + v * newer.stride + u;
        const BlockMatch expected = portable.match(block, reference.stride, window, newer.stride, range);
        const BlockMatch got = kernel.match(block, reference.stride, window, newer.stride, range);
        ASSERT_TRUE(same(expected, got)) << kernel.name << ", case " << i;
    }
}

TEST(DefaultKernel, IsTheOneOfTheEnvironment) {
    setenv("FLOWNAV_KERNEL", "portable", 1);
    EXPECT_STREQ(default_kernel().name, "portable");
    setenv("FLOWNAV_KERNEL", "mmx", 1);
    EXPECT_THROW(default_kernel(), std::runtime_error);
    unsetenv("FLOWNAV_KERNEL");
    EXPECT_EQ(&default_kernel(), &select_kernel());
}

}  // namespace
}  // namespace flownav::flow
