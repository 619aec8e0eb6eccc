#include "flownav/flow/kernel.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace flownav::flow {
namespace {

constexpr int window_px = 32;
using Window = std::array<std::uint8_t, window_px * window_px>;

Window noise(unsigned seed) {
    std::mt19937 random(seed);
    Window w;
    for (auto& p : w) p = static_cast<std::uint8_t>(random() & 0xFF);
    return w;
}

/// Top left pixel at offset (mu, nu) of a 32x32 window.
const std::uint8_t* at(const Window& w, int mu, int nu) {
    return w.data() + (nu - search_min) * window_px + (mu - search_min);
}

BlockMatch match(const std::uint8_t* block, const Window& w, const SearchRange& range = {}) {
    return select_kernel().match(block, window_px, at(w, 0, 0), window_px, range);
}

/// Eq. (2), literally.
int sad_by_definition(const std::uint8_t* block, const std::uint8_t* other) {
    int sum = 0;
    for (int i = 0; i < block_px * block_px; ++i) {
        const int k = i / block_px * window_px + i % block_px;
        sum += std::abs(block[k] - other[k]);
    }
    return sum;
}

TEST(Kernel, FindsEveryDisplacementOfTheWindow) {
    const Window w = noise(1);
    for (int nu = search_min; nu <= search_max; ++nu) {
        for (int mu = search_min; mu <= search_max; ++mu) {
            const BlockMatch m = match(at(w, mu, nu), w);
            EXPECT_EQ(m.mu, mu);
            EXPECT_EQ(m.nu, nu);
            EXPECT_EQ(m.minimum, 0);
        }
    }
}

TEST(Kernel, CostsAreTheSumsOfAbsoluteDifferences) {
    const Window w = noise(2);
    const Window other = noise(3);
    const SadSurface s = sad_surface(at(other, 0, 0), window_px, at(w, 0, 0), window_px, {});
    for (int nu = search_min; nu <= search_max; ++nu) {
        for (int mu = search_min; mu <= search_max; ++mu) {
            EXPECT_EQ(s[(nu - search_min) * search_px + mu - search_min],
                      sad_by_definition(at(other, 0, 0), at(w, mu, nu)));
        }
    }
}

TEST(Kernel, BlackOnWhiteDoesNotOverflow) {
    Window black{};
    Window white;
    white.fill(255);
    EXPECT_EQ(match(black.data(), white).minimum, 16 * 16 * 255);
}

TEST(Kernel, TieGoesToSmallestDisplacement) {
    const Window flat{};
    const BlockMatch m = match(flat.data(), flat);
    EXPECT_EQ(m.mu, 0);
    EXPECT_EQ(m.nu, 0);
    EXPECT_EQ(m.minimum, 0);
    EXPECT_EQ(m.second, 0);
}

TEST(Kernel, TieOfEquallySmallDisplacementsGoesToTheFirstInRasterOrder) {
    SadSurface s;
    s.fill(100);
    for (const auto& [mu, nu] : {std::pair{1, 2}, {-1, 2}, {2, -1}, {-2, 1}}) {
        s[(nu - search_min) * search_px + mu - search_min] = 7;
    }
    const BlockMatch m = summarise(s, {});
    EXPECT_EQ(m.mu, 2);
    EXPECT_EQ(m.nu, -1);
}

TEST(Kernel, SecondMinimumKeepsItsDistance) {
    SadSurface s;
    s.fill(1000);
    const auto cost = [&](int mu, int nu) -> std::uint16_t& {
        return s[(nu - search_min) * search_px + mu - search_min];
    };
    cost(1, 1) = 10;
    cost(3, 3) = 20;  // two pixels off: part of the same minimum
    cost(4, 1) = 30;  // three pixels off: a separate minimum
    const BlockMatch m = summarise(s, {});
    EXPECT_EQ(m.minimum, 10);
    EXPECT_EQ(m.second, 30);
    EXPECT_EQ(m.sum, 253U * 1000 + 60);
}

TEST(Kernel, NeighboursOfTheMinimumAreReported) {
    SadSurface s;
    s.fill(1000);
    const auto cost = [&](int mu, int nu) -> std::uint16_t& {
        return s[(nu - search_min) * search_px + mu - search_min];
    };
    cost(2, -3) = 1;
    cost(1, -3) = 11;
    cost(3, -3) = 12;
    cost(2, -4) = 13;
    cost(2, -2) = 14;
    const BlockMatch m = summarise(s, {});
    EXPECT_EQ(m.left, 11);
    EXPECT_EQ(m.right, 12);
    EXPECT_EQ(m.above, 13);
    EXPECT_EQ(m.below, 14);
}

TEST(Kernel, ClippedWindowTriesOnlyWhatIsInside) {
    const Window w = noise(4);
    const SearchRange range{-2, 7, -8, 3};
    const BlockMatch outside = match(at(w, -5, 0), w, range);
    EXPECT_GT(outside.minimum, 0);
    EXPECT_GE(outside.mu, -2);
    const BlockMatch border = match(at(w, -2, 3), w, range);
    EXPECT_EQ(border.minimum, 0);
    EXPECT_EQ(border.left, no_cost);
    EXPECT_EQ(border.below, no_cost);
    EXPECT_NE(border.right, no_cost);
}

TEST(Kernel, UnknownNameIsAnErrorThatNamesTheKnownOnes) {
    try {
        select_kernel("mmx");
        FAIL() << "accepted";
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find("portable"), std::string::npos);
    }
}

}  // namespace
}  // namespace flownav::flow
