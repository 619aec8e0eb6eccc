// No matcher reads outside an image, for any positions, sizes and predictions.
#include "flownav/flow/block_bounds.h"

#include <gtest/gtest.h>

#include <limits>

#include "flownav/flow/matcher.h"
#include "guarded_memory.h"

namespace flownav::flow {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr int size_px = 64;  // a page of pixels

/// Whole pages of noise between guard pages: reads before the first or after the last pixel crash.
struct Picture {
    Picture() {
        std::uint32_t state = 1;
        for (std::uint8_t* pixel = memory.begin(); pixel != memory.end(); ++pixel) {
            state = state * 1664525U + 1013904223U;
            *pixel = static_cast<std::uint8_t>(state >> 24U);
        }
    }
    ImageView view() const { return {memory.begin(), size_px, size_px, size_px}; }

    testing::GuardedMemory memory{1};
};

/// A layout with blocks at these corners.
BlockLayout layout_of(const std::vector<Eigen::Vector2i>& corners_px) {
    BlockLayout layout;
    layout.corner_px = corners_px;
    for (const Eigen::Vector2i& corner : corners_px)
        layout.centre_px.emplace_back(corner.cast<double>().array() + 7.5);
    return layout;
}

class BlockBounds : public ::testing::TestWithParam<std::size_t> {
  protected:
    void SetUp() override {
        if (!kernel().supported()) GTEST_SKIP() << "this processor has no " << kernel().name;
    }
    static const KernelEntry& kernel() { return kernel_table()[GetParam()]; }

    std::vector<FlowVector> match(const BlockLayout& layout,
                                  const std::vector<Eigen::Vector2d>& predicted_px) const {
        FlowParams params;
        params.brightness = BrightnessModel::Image;
        std::vector<FlowVector> vectors;
        BlockMatcher(params, 1, kernel())(first_.view(), second_.view(), layout, predicted_px, vectors);
        return vectors;
    }

    Picture first_, second_;
};

TEST_P(BlockBounds, PredictionsFarOutsideFindNoWindow) {
    const std::vector<double> wild = {1e9,   -1e9,     2147483647.0, -2147483648.0, 4294967296.0 * 3 + 8,
                                      1e300, infinite, -infinite,    not_a_number};
    std::vector<Eigen::Vector2i> corners;
    std::vector<Eigen::Vector2d> predicted;
    for (const double x : wild) {
        corners.insert(corners.end(), {{0, 0}, {48, 48}, {20, 30}});
        predicted.insert(predicted.end(), {{x, 0.0}, {0.0, x}, {x, x}});
    }
    for (const FlowVector& vector : match(layout_of(corners), predicted)) EXPECT_FALSE(vector.valid);
}

TEST_P(BlockBounds, BlocksOutsideTheReferenceAreNotMatched) {
    const std::vector<Eigen::Vector2i> corners = {{-1, 0},  {0, -1},  {49, 0},          {0, 49},
                                                  {-99, 3}, {3, 990}, {2000000000, 10}, {10, -2000000000}};
    // Predictions that keep every window inside the newer image.
    std::vector<Eigen::Vector2d> predicted;
    for (const Eigen::Vector2i& corner : corners)
        predicted.emplace_back(Eigen::Vector2d(20, 20) - corner.cast<double>());
    for (const FlowVector& vector : match(layout_of(corners), predicted)) EXPECT_FALSE(vector.valid);
}

TEST_P(BlockBounds, WindowsAreClippedOnAllFourSides) {
    const std::vector<Eigen::Vector2i> corners(9, {24, 24});
    std::vector<Eigen::Vector2d> predicted;
    for (const double x : {-24.0, 0.0, 24.0})
        for (const double y : {-24.0, 0.0, 24.0}) predicted.emplace_back(x, y);
    for (const FlowVector& vector : match(layout_of(corners), predicted)) EXPECT_TRUE(vector.valid);
}

TEST_P(BlockBounds, ANewerImageTooSmallForABlockHasNoMatch) {
    const Picture first, second;
    for (const auto& [width, height] : {std::pair{0, 0}, {1, 1}, {15, 64}, {64, 15}}) {
        const ImageView small{second.memory.begin(), width, height, size_px};
        std::vector<FlowVector> vectors;
        BlockMatcher(FlowParams{}, 1, kernel())(first.view(), small, layout_of({{0, 0}}), {{0.0, 0.0}},
                                                vectors);
        EXPECT_FALSE(vectors.front().valid) << width << " x " << height;
    }
}

INSTANTIATE_TEST_SUITE_P(AllKernels, BlockBounds, ::testing::Range<std::size_t>(0, kernel_table().size()),
                         [](const auto& test) { return std::string(kernel_table()[test.param].name); });

TEST(WholePx, RoundsToTheNearestOnBothSidesOfZero) {
    EXPECT_EQ(whole_px({1.4, -1.4}), Eigen::Vector2i(1, -1));
    EXPECT_EQ(whole_px({1.6, -1.6}), Eigen::Vector2i(2, -2));
}

TEST(WholePx, WhatNoIntegerHoldsIsFarAway) {
    for (const double value : {1e9, -1e9, 1e300, infinite, not_a_number})
        EXPECT_EQ(whole_px({value, -value}), Eigen::Vector2i::Constant(100000000)) << value;
}

}  // namespace
}  // namespace flownav::flow
