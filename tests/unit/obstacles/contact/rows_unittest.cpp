#include "rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace flownav::obstacles::rows {
namespace {

constexpr int width = 150;
constexpr int height = 40;

/// Grey levels with a hole where the camera did not look.
std::vector<float> noisy_image(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<float> grey(static_cast<std::size_t>(width * height));
    for (float& g : grey) g = static_cast<float>(random() % 1000U) / 4.0F;
    for (std::size_t i = 20 * width + 30; i < 20 * width + 40; ++i) grey[i] = NAN;
    return grey;
}

/// Places that leave the image on every side.
Places some_places() {
    return {-8.0F, 1.05F, 15.0F, 0.02F, 1.0F, -0.0004F};
}

bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::isnan(a[i]) && std::isnan(b[i])) continue;
        if (std::memcmp(&a[i], &b[i], sizeof(float)) != 0) return false;
    }
    return true;
}

std::vector<float> warped(const Functions& functions) {
    const std::vector<float> grey = noisy_image(1);
    std::vector<float> out(width, -1.0F);
    functions.warp({grey.data(), width, height}, some_places(), 0, width, out.data());
    return out;
}

/// All that costs(), preferences(), edges() and differences() write, one after the other.
std::vector<float> costs_of(const Functions& functions) {
    const std::vector<float> now = noisy_image(2);
    const std::vector<float> before = noisy_image(3);
    const std::vector<float> offset(width, 1.5F);
    std::vector<float> cost(width);
    std::vector<float> steepness2(width);
    std::vector<Packed> counts(width);
    std::vector<Packed> evidence(width);
    std::vector<float> preference(width);
    std::vector<float> sums(width, 0.5F);
    std::vector<float> numbers(width, 3.0F);
    CostRow row{};
    row.above = now.data() + 19 * width;
    row.now = now.data() + 20 * width;
    row.below = now.data() + 21 * width;
    row.before = before.data() + 20 * width;
    row.before_nearer = before.data() + 22 * width;
    row.offset = offset.data();
    row.places = some_places();
    row.v = 20.0F;
    row.w0 = 0.3F;
    row.w1 = 0.0001F;
    row.bx = 3.0F;
    row.by = 14.0F;
    row.bz = 0.16F;
    row.gain = 1.02F;
    row.noise = 1.3F;
    row.cost = cost.data();
    row.steepness2 = steepness2.data();
    row.counts = counts.data();
    row.evidence = evidence.data();
    row.preference = preference.data();
    functions.costs(row, 1, width - 1);
    functions.preferences(row, 1, width - 1);
    functions.differences(row, 3.0F, 1, width - 1, sums.data(), numbers.data());
    std::vector<float> all = cost;
    all.insert(all.end(), steepness2.begin(), steepness2.end());
    all.insert(all.end(), preference.begin(), preference.end());
    all.insert(all.end(), sums.begin(), sums.end());
    all.insert(all.end(), numbers.begin(), numbers.end());
    const auto add = [&](const std::vector<Packed>& values) {
        for (const Packed p : values) all.push_back(static_cast<float>(p));
    };
    add(counts);
    add(evidence);
    functions.edges(row, 1, width - 1);
    add(counts);
    return all;
}

std::vector<float> votes_of(const Functions& functions) {
    const std::vector<float> grey = noisy_image(4);
    std::vector<float> inverse;
    for (int i = 0; i < 37; ++i) inverse.push_back(0.2F + 0.04F * static_cast<float>(i));
    std::vector<float> sums(inverse.size(), 0.25F);
    const Vote vote{70.0F, 20.0F, 130.0F, 400.0F, 3.5F, 70.0F, 20.0F, 1.0F, 12.0F, 9.0F, 0.15F, 1.7F, 0.8F};
    functions.vote({grey.data(), width, height}, vote, inverse.data(), static_cast<int>(inverse.size()),
                   sums.data());
    return sums;
}

TEST(Rows, EveryInstructionSetGivesTheSameBytes) {
    EXPECT_TRUE(same_bytes(warped(functions()), warped(portable_functions())));
    EXPECT_TRUE(same_bytes(costs_of(functions()), costs_of(portable_functions())));
    EXPECT_TRUE(same_bytes(votes_of(functions()), votes_of(portable_functions())));
}

TEST(Rows, APlaceBetweenFourPixelsHasTheirWeightedMean) {
    std::vector<float> grey(static_cast<std::size_t>(width * height), 0.0F);
    grey[5 * width + 11] = 100.0F;
    std::vector<float> out(1, 0.0F);
    functions().warp({grey.data(), width, height}, {10.25F, 0.0F, 4.5F, 0.0F, 1.0F, 0.0F}, 0, 1, out.data());
    EXPECT_FLOAT_EQ(out[0], 12.5F);
}

TEST(Rows, PlacesOutsideTheImageAreNoNumbers) {
    const std::vector<float> grey(static_cast<std::size_t>(width * height), 7.0F);
    const Reference image{grey.data(), width, height};
    float out = 0.0F;
    for (const auto& [x, y] : {std::pair(-0.1F, 5.0F),
                               {149.0F, 5.0F},
                               {5.0F, -0.1F},
                               {5.0F, 39.0F},
                               {1e30F, 5.0F},
                               {5.0F, -1e30F},
                               {NAN, 5.0F}}) {
        functions().warp(image, {x, 0.0F, y, 0.0F, 1.0F, 0.0F}, 0, 1, &out);
        EXPECT_TRUE(std::isnan(out)) << x << ' ' << y;
    }
}

TEST(Rows, AVoteIsForTheContactWhoseGreyLevelFits) {
    // The grey level grows with the column; the pixel's own is that of column 80, reached at 0.5 / m.
    std::vector<float> grey(static_cast<std::size_t>(width * height));
    for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = static_cast<float>(i % width);
    const Vote vote{70.0F, 20.0F, 80.0F, 0.0F, 4.0F, 70.0F, 20.0F, 1.0F, 20.0F, 0.0F, 0.0F, 1.0F, 1.0F};
    const std::vector<float> inverse = {0.25F, 0.5F, 0.75F};
    std::vector<float> sums(3, 0.0F);
    functions().vote({grey.data(), width, height}, vote, inverse.data(), 3, sums.data());
    const float telling = 2.0F / 3.0F;  // two of three contacts do not fit
    EXPECT_FLOAT_EQ(sums[0], -against * telling);
    EXPECT_FLOAT_EQ(sums[1], 4.0F * telling);
    EXPECT_FLOAT_EQ(sums[2], -against * telling);
}

TEST(Rows, APixelThatFitsEverywhereVotesLittle) {
    const std::vector<float> grey(static_cast<std::size_t>(width * height), 80.0F);
    const Vote vote{70.0F, 20.0F, 80.0F, 0.0F, 4.0F, 70.0F, 20.0F, 1.0F, 20.0F, 0.0F, 0.0F, 1.0F, 1.0F};
    const std::vector<float> inverse = {0.25F, 0.5F, 0.75F};
    std::vector<float> sums(3, 0.0F);
    functions().vote({grey.data(), width, height}, vote, inverse.data(), 3, sums.data());
    for (const float sum : sums) EXPECT_FLOAT_EQ(sum, 4.0F * least_telling);
}

TEST(Rows, WhatFitsFloorBetterThanSomethingNearerHasAPreferenceAboveZero) {
    const std::vector<float> now(3 * 16, 50.0F);
    const std::vector<float> floor(16, 50.5F);
    std::vector<float> nearer(16, 53.0F);
    nearer[5] = NAN;
    const std::vector<float> offset(16, 0.0F);
    std::vector<float> cost(16, 0.25F);
    std::vector<float> steepness2(16, 0.0F);
    std::vector<float> preference(16, -1.0F);
    CostRow row{};
    row.now = now.data();
    row.before = floor.data();
    row.before_nearer = nearer.data();
    row.offset = offset.data();
    row.gain = 1.0F;
    row.noise = 1.5F;
    row.cost = cost.data();
    row.steepness2 = steepness2.data();
    row.preference = preference.data();
    functions().preferences(row, 0, 16);
    EXPECT_FLOAT_EQ(preference[4], 2.0F - 0.25F);
    EXPECT_FLOAT_EQ(preference[5], 0.0F) << "nothing is known of it";
}

}  // namespace
}  // namespace flownav::obstacles::rows
