#include "flownav/flow/subpixel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace flownav::flow {
namespace {

TEST(Subpixel, VFitFindsTheTipOfAV) {
    for (double tip = -0.45; tip < 0.46; tip += 0.05) {
        const auto cost = [&](int x) {
            return static_cast<int>(std::lround(1000 + 4000 * std::abs(x - tip)));
        };
        EXPECT_NEAR(refine(cost(-1), cost(0), cost(1), Subpixel::V), tip, 1e-3);
    }
}

TEST(Subpixel, ParabolaFindsTheVertexOfAParabola) {
    for (double tip = -0.45; tip < 0.46; tip += 0.05) {
        const auto cost = [&](int x) {
            return static_cast<int>(std::lround(1000 + 4000 * (x - tip) * (x - tip)));
        };
        EXPECT_NEAR(refine(cost(-1), cost(0), cost(1), Subpixel::Parabola), tip, 1e-3);
    }
}

TEST(Subpixel, NoneKeepsTheInteger) {
    EXPECT_EQ(refine(50, 10, 20, Subpixel::None), 0.0);
}

TEST(Subpixel, SmallerCostBehindPullsBehind) {
    EXPECT_GT(refine(50, 10, 20, Subpixel::V), 0.0);
    EXPECT_LT(refine(20, 10, 50, Subpixel::V), 0.0);
}

TEST(Subpixel, FlatOrOneSidedSurfacesAreNotRefined) {
    EXPECT_EQ(refine(10, 10, 10, Subpixel::V), 0.0);
    EXPECT_EQ(refine(no_cost, 10, 50, Subpixel::V), 0.0);
    EXPECT_EQ(refine(50, 10, no_cost, Subpixel::Parabola), 0.0);
}

TEST(Subpixel, RightAndDownArePositive) {
    BlockMatch m;
    m.minimum = 10;
    m.mu = 3;
    m.nu = -2;
    m.left = 50;
    m.right = 20;
    m.above = 20;
    m.below = 50;
    const Eigen::Vector2d d = refined_offset_px(m, Subpixel::V);
    EXPECT_GT(d.x(), 3.0);
    EXPECT_LT(d.y(), -2.0);
}

TEST(Confidence, IsTheRelativeDistanceOfTheSecondMinimum) {
    BlockMatch m;
    m.minimum = 60;
    m.second = 100;
    m.left = m.right = m.above = m.below = 80;
    EXPECT_DOUBLE_EQ(confidence_of(m), 0.4);
}

TEST(Confidence, AMinimumOnTheBorderOfItsWindowIsWorthNothing) {
    BlockMatch m;
    m.minimum = 60;
    m.second = 100;
    m.left = m.right = m.above = 80;
    EXPECT_EQ(confidence_of(m), 0.0);
}

TEST(Confidence, AConstantBlockIsWorthNothing) {
    BlockMatch m;
    m.minimum = m.second = m.left = m.right = m.above = m.below = 0;
    EXPECT_EQ(confidence_of(m), 0.0);
}

}  // namespace
}  // namespace flownav::flow
