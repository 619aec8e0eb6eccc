#include "flownav/flow/match_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "flownav/testing/scene.h"

namespace flownav::flow {
namespace {

struct Pair {
    testing::Scene scene = testing::make_scene(testing::SceneKind::Free, 7);
    Field first = testing::make_field(scene, 0);
    Field second = testing::make_field(scene, 1);
    BlockLayout layout = place_blocks(RayMapper(first.camera), {});
    std::vector<Eigen::Vector2i> no_bias =
        std::vector<Eigen::Vector2i>(layout.size(), Eigen::Vector2i::Zero());

    std::vector<FlowVector> match(Subpixel subpixel, int threads = 1) const {
        MatchSettings settings;
        settings.subpixel = subpixel;
        settings.threads = threads;
        std::vector<FlowVector> vectors;
        match_blocks(first.image, second.image, layout, no_bias, settings, vectors);
        return vectors;
    }

    /// Median error of the flow, pixels.
    double median_error_px(Subpixel subpixel) const {
        std::vector<double> errors;
        for (const FlowVector& v : match(subpixel)) {
            if (!v.valid || v.confidence < 0.06) continue;
            const auto truth =
                exact_flow(scene.world, testing::true_view(scene, 0), testing::true_view(scene, 1), v.at_px);
            if (truth) errors.push_back((v.flow_px - truth->flow_px).norm());
        }
        EXPECT_GT(errors.size(), layout.size() / 2);
        std::nth_element(errors.begin(), errors.begin() + static_cast<long>(errors.size() / 2), errors.end());
        return errors[errors.size() / 2];
    }
};

TEST(MatchBlocks, MeasuresTheExactFlowOfARenderedFloor) {
    const Pair pair;
    EXPECT_LT(pair.median_error_px(Subpixel::V), 0.15);
    EXPECT_LT(pair.median_error_px(Subpixel::Parabola), 0.25);
    EXPECT_LT(pair.median_error_px(Subpixel::None), 0.6);
}

TEST(MatchBlocks, SubpixelFitIsBetterThanIntegers) {
    const Pair pair;
    EXPECT_LT(pair.median_error_px(Subpixel::V), pair.median_error_px(Subpixel::None) / 2);
}

TEST(MatchBlocks, ResultDoesNotDependOnTheNumberOfThreads) {
    const Pair pair;
    const auto one = pair.match(Subpixel::V, 1);
    const auto two = pair.match(Subpixel::V, 2);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].flow_px, two[i].flow_px);
        EXPECT_EQ(one[i].confidence, two[i].confidence);
    }
}

TEST(MatchBlocks, InAnotherLightEveryGreyIsAsTheMapSays) {
    const Pair pair;
    const Eigen::Vector2i shift_px(3, -2);
    for (const Brightness& light : {Brightness{1.3, -20.0}, {0.7, 11.0}, {1.0, 4.4}, {1.9, 30.0}}) {
        MatchSettings settings;
        settings.brightness = light;
        const GreyMap shown(light);
        testing::GreyImage other(pair.first.image.width_px, pair.first.image.height_px);
        for (int v = 2; v < other.height_px; ++v) {
            for (int u = 3; u < other.width_px; ++u)
                other.row(v + shift_px.y())[u] = shown(pair.first.image.at(u - shift_px.x(), v));
        }
        std::vector<FlowVector> vectors;
        match_blocks(pair.first.image, other.view(), pair.layout, pair.no_bias, settings, vectors);
        int exact = 0;
        for (const FlowVector& v : vectors) exact += v.confidence == 1.0;  // their smallest sum is 0
        EXPECT_GT(exact, 300) << light.gain;
    }
}

TEST(MatchBlocks, AWindowOutsideTheImageIsNotMeasured) {
    const Pair pair;
    std::vector<FlowVector> vectors;
    const std::vector<Eigen::Vector2i> far(pair.layout.size(), Eigen::Vector2i(5000, 0));
    match_blocks(pair.first.image, pair.second.image, pair.layout, far, {}, vectors);
    ASSERT_EQ(vectors.size(), pair.layout.size());
    for (const FlowVector& v : vectors) EXPECT_FALSE(v.valid);
}

TEST(MatchBlocks, WindowIsClippedAtEachBorder) {
    const ImageView image{nullptr, 100, 80, 100};
    const SearchRange corner = clipped_range({0, 0}, {0, 0}, image);
    EXPECT_EQ(corner.mu_min, 0);
    EXPECT_EQ(corner.nu_min, 0);
    EXPECT_EQ(corner.mu_max, search_max);
    const SearchRange other = clipped_range({84, 64}, {-3, -2}, image);
    EXPECT_EQ(other.mu_max, 3);
    EXPECT_EQ(other.nu_max, 2);
    EXPECT_TRUE(clipped_range({0, 0}, {-9, 0}, image).empty());
}

TEST(MatchBlocks, BiasShiftsTheWindow) {
    const Pair pair;
    std::vector<FlowVector> vectors;
    const std::vector<Eigen::Vector2i> bias(pair.layout.size(), Eigen::Vector2i(3, -2));
    match_blocks(pair.first.image, pair.second.image, pair.layout, bias, {}, vectors);
    const auto centred = pair.match(Subpixel::V);
    int same = 0;
    for (std::size_t i = 0; i < vectors.size(); ++i)
        same += (vectors[i].flow_px - centred[i].flow_px).norm() < 1e-9;
    EXPECT_GT(same, static_cast<int>(vectors.size() / 2));
}

}  // namespace
}  // namespace flownav::flow
