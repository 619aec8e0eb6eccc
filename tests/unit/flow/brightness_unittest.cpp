#include "flownav/flow/brightness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/flow/matcher.h"
#include "flownav/testing/scene.h"

namespace flownav::flow {
namespace {

using testing::GreyImage;

/// Two images of a drive over a carpet with different exposure.
struct Exposed {
    testing::Scene scene = testing::make_scene(testing::SceneKind::Free, 7);
    GreyImage first, second;
    CameraModel camera = testing::nominal_view(scene, 0).camera;
    BlockLayout layout = place_blocks(RayMapper(camera), {});

    explicit Exposed(const Brightness& change) {
        testing::ImageEffects effects;
        effects.noise_sigma = 2.5;
        first = testing::render(scene.world, testing::nominal_view(scene, 0), effects);
        effects.noise_seed = 1;
        effects.gain = change.gain;
        effects.offset = change.offset;
        second = testing::render(scene.world, testing::nominal_view(scene, 1), effects);
    }

    Brightness compared() const {
        GreySums sums;
        return compare_brightness(first.view(), second.view(), layout,
                                  std::vector<Eigen::Vector2i>(layout.size(), Eigen::Vector2i::Zero()), sums);
    }

    /// Number of confident vectors that are right within a pixel.
    int right(BrightnessModel model) const {
        FlowParams params;
        params.brightness = model;
        std::vector<FlowVector> vectors;
        BlockMatcher matcher(params, 1);
        matcher(first.view(), second.view(), layout,
                std::vector<Eigen::Vector2d>(layout.size(), Eigen::Vector2d::Zero()), vectors);
        int count = 0;
        for (const FlowVector& v : vectors) {
            const auto truth =
                exact_flow(scene.world, testing::true_view(scene, 0), testing::true_view(scene, 1), v.at_px);
            count += v.valid && v.confidence >= params.confidence_min && truth &&
                     (v.flow_px - truth->flow_px).norm() < 1.0;
        }
        return count;
    }
};

TEST(Brightness, GainAndOffsetOfAnExposureStepAreFound) {
    for (const Brightness& change : {Brightness{1.0, 0.0}, {1.10, 0.0}, {0.9, 0.0}, {1.06, 4.0}}) {
        const Brightness found = Exposed(change).compared();
        EXPECT_NEAR(found.gain, change.gain, 0.02);
        EXPECT_NEAR(found.gain * 115.0 + found.offset, change.gain * 115.0 + change.offset, 0.5);
    }
}

TEST(Brightness, MatchingSurvivesAnExposureStep) {
    const Exposed exposed({1.10, 4.0});
    EXPECT_LT(exposed.right(BrightnessModel::Constant), 50);
    EXPECT_GT(exposed.right(BrightnessModel::Image), 300);
}

TEST(Brightness, SomethingDarkThatMovesInDoesNotCount) {
    Exposed exposed({1.0, 0.0});
    for (int v = 0; v < exposed.second.height_px; ++v) {
        for (int u = 0; u < exposed.second.width_px / 5; ++u) exposed.second.row(v)[u] = 10;
    }
    EXPECT_NEAR(exposed.compared().gain, 1.0, 0.03);
    EXPECT_NEAR(exposed.compared().gain * 115.0 + exposed.compared().offset, 115.0, 1.0);
}

TEST(Brightness, ConstantImagesHaveNoGain) {
    const GreyImage black(64, 64);
    BlockLayout layout;
    layout.corner_px.assign(4, Eigen::Vector2i(8, 8));
    GreySums sums;
    const Brightness b = compare_brightness(black.view(), black.view(), layout,
                                            std::vector<Eigen::Vector2i>(4, Eigen::Vector2i::Zero()), sums);
    EXPECT_EQ(b.gain, 1.0);
    EXPECT_EQ(b.offset, 0.0);
}

TEST(Brightness, NothingInCommonMeansNoChange) {
    const GreyImage image(64, 64);
    BlockLayout layout;
    layout.corner_px.assign(4, Eigen::Vector2i(8, 8));
    GreySums sums;
    const Brightness b = compare_brightness(image.view(), image.view(), layout,
                                            std::vector<Eigen::Vector2i>(4, Eigen::Vector2i(500, 0)), sums);
    EXPECT_EQ(b.gain, 1.0);
    EXPECT_EQ(b.offset, 0.0);
}

TEST(GreyTable, IsClampedAtBlackAndWhite) {
    const GreyTable table = grey_table({2.0, -20.0});
    EXPECT_EQ(table[0], 0);
    EXPECT_EQ(table[50], 80);
    EXPECT_EQ(table[255], 255);
}

TEST(GreyTable, IsRightToHalfAGreyLevel) {
    for (const Brightness& b :
         {Brightness{1.0, 0.3}, {1.37, -20.0}, {0.61, 90.7}, {2.0, -140.0}, {0.5, 0.0}}) {
        const GreyTable table = grey_table(b);
        for (std::size_t grey = 0; grey < table.size(); ++grey) {
            const double exact = std::clamp(b.gain * static_cast<double>(grey) + b.offset, 0.0, 255.0);
            EXPECT_NEAR(table[grey], exact, 0.5 + 1.0 / 32.0) << b.gain << ' ' << b.offset << ' ' << grey;
        }
    }
}

TEST(GreyTable, EvenNonsenseIsClamped) {
    EXPECT_EQ(grey_table({1.0, 1e9})[0], 255);
    EXPECT_EQ(grey_table({1.0, -1e9})[255], 0);
    EXPECT_EQ(grey_table({1e9, 0.0})[200], 255);
    EXPECT_EQ(grey_table({-5.0, 0.0})[200], 0);
}

TEST(GreyTable, NoChangeIsTheIdentity) {
    const GreyTable table = grey_table({});
    for (std::size_t grey = 0; grey < table.size(); ++grey) EXPECT_EQ(table[grey], grey);
}

}  // namespace
}  // namespace flownav::flow
