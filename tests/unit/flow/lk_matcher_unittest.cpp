#include "flownav/flow/lk_matcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flownav/testing/scene.h"

namespace flownav::flow {
namespace {

using Eigen::Vector2d;

double median(std::vector<double> values) {
    if (values.empty()) return NAN;
    const auto middle = values.begin() + static_cast<long>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

testing::SceneOptions free_floor(sim::Surface floor) {
    testing::SceneOptions options;
    options.kind = testing::SceneKind::Free;
    options.seed = 7;
    options.images = 4;
    options.floor = floor;
    return options;
}

/// Two images of a drive over a floor, three images apart.
struct Pair {
    testing::Scene scene;
    Field first, second;
    BlockLayout layout;
    std::vector<Vector2d> predicted_px;

    explicit Pair(const testing::SceneOptions& options = free_floor(sim::Surface::Carpet))
        : scene(testing::make_scene(options)),
          first(testing::make_field(scene, 0)),
          second(testing::make_field(scene, 3)),
          layout(place_blocks(RayMapper(first.camera), {})),
          predicted_px(layout.size(), Vector2d(0.0, 5.0)) {}

    Vector2d truth_px(const Vector2d& at_px) const {
        const auto truth =
            exact_flow(scene.world, testing::true_view(scene, 0), testing::true_view(scene, 3), at_px);
        return truth ? truth->flow_px : Vector2d(NAN, NAN);
    }

    std::vector<FlowVector> match(const LkSettings& settings = {}) const {
        std::vector<FlowVector> vectors;
        LkMatcher{settings}(first.image, second.image, layout, predicted_px, vectors);
        return vectors;
    }
};

bool is_confident(const FlowVector& v) {
    return v.valid && v.confidence >= FlowParams{}.confidence_min;
}

TEST(LkMatcher, MeasuresTheExactFlowOfARenderedFloor) {
    const Pair pair;
    std::vector<double> errors_px;
    int wrong = 0;
    for (const FlowVector& v : pair.match()) {
        if (!is_confident(v)) continue;
        errors_px.push_back((v.flow_px - pair.truth_px(v.at_px)).norm());
        wrong += errors_px.back() > 1.0;
    }
    EXPECT_GT(errors_px.size(), pair.layout.size() * 3 / 4);
    EXPECT_LT(median(errors_px), 0.1);
    EXPECT_LE(wrong, 3);
}

TEST(LkMatcher, SigmaTellsTheErrorOnGoodAndPoorFloors) {
    for (const auto floor : {sim::Surface::Carpet, sim::Surface::Lino, sim::Surface::Marbled}) {
        Pair pair(free_floor(floor));
        for (std::size_t i = 0; i < pair.layout.size(); ++i)
            pair.predicted_px[i] = pair.truth_px(pair.layout.centre_px[i]) + Vector2d(0.5, -0.5);
        std::vector<double> errors_in_sigma;
        for (const FlowVector& v : pair.match()) {
            if (!is_confident(v)) continue;
            const Vector2d error_px = v.flow_px - pair.truth_px(v.at_px);
            for (const int k : {0, 1}) errors_in_sigma.push_back(std::abs(error_px[k]) / v.sigma_px[k]);
        }
        EXPECT_GT(errors_in_sigma.size(), pair.layout.size()) << static_cast<int>(floor);
        EXPECT_NEAR(median(errors_in_sigma), 0.67, 0.25) << static_cast<int>(floor);
    }
}

TEST(LkMatcher, ExposureThatChangesIsCompensated) {
    Pair pair;
    auto brighter =
        std::make_shared<testing::GreyImage>(pair.second.image.width_px, pair.second.image.height_px);
    for (int v = 0; v < brighter->height_px; ++v) {
        for (int u = 0; u < brighter->width_px; ++u) {
            const long grey = std::lround(1.1 * pair.second.image.at(u, v) + 4);
            brighter->row(v)[u] = static_cast<std::uint8_t>(std::clamp(grey, 0L, 255L));
        }
    }
    pair.second.image = brighter->view();
    const auto error_px = [&](BrightnessModel brightness) {
        LkSettings settings;
        settings.brightness = brightness;
        std::vector<double> errors_px;
        for (const FlowVector& v : pair.match(settings)) {
            if (v.valid) errors_px.push_back((v.flow_px - pair.truth_px(v.at_px)).norm());
        }
        return median(errors_px);
    };
    EXPECT_LT(error_px(BrightnessModel::Image), 0.1);
    EXPECT_LT(error_px(BrightnessModel::Image), error_px(BrightnessModel::Constant) / 2);
}

TEST(LkMatcher, WithoutTextureNothingIsConfident) {
    Pair pair;
    testing::GreyImage grey(pair.first.image.width_px, pair.first.image.height_px);
    std::fill(grey.pixels.begin(), grey.pixels.end(), std::uint8_t{128});
    pair.first.image = pair.second.image = grey.view();
    const std::vector<FlowVector> vectors = pair.match();
    ASSERT_EQ(vectors.size(), pair.layout.size());
    for (const FlowVector& v : vectors) EXPECT_FALSE(is_confident(v));
}

TEST(LkMatcher, ABlockPredictedOutsideTheImageIsNotMeasured) {
    Pair pair;
    pair.predicted_px.assign(pair.layout.size(), Vector2d(5000.0, 0.0));
    const std::vector<FlowVector> vectors = pair.match();
    ASSERT_EQ(vectors.size(), pair.layout.size());
    for (const FlowVector& v : vectors) EXPECT_FALSE(v.valid);
}

TEST(LkMatcher, AWrongPredictionIsFoundOutOrMadeGood) {
    Pair pair;
    for (Vector2d& p : pair.predicted_px) p += Vector2d(6.0, -6.0);
    int confident = 0, wrong = 0;
    for (const FlowVector& v : pair.match()) {
        confident += is_confident(v);
        wrong += is_confident(v) && (v.flow_px - pair.truth_px(v.at_px)).norm() > 1.0;
    }
    EXPECT_GT(confident, static_cast<int>(pair.layout.size() / 4));
    EXPECT_LT(wrong, confident / 10);
}

TEST(LkMatcher, RepeatsToTheLastBit) {
    const Pair pair;
    const auto once = pair.match();
    for (int i = 0; i < 3; ++i) {
        const auto again = pair.match();
        ASSERT_EQ(again.size(), once.size());
        for (std::size_t k = 0; k < once.size(); ++k) {
            ASSERT_EQ(again[k].flow_px, once[k].flow_px);
            ASSERT_EQ(again[k].sigma_px, once[k].sigma_px);
            ASSERT_EQ(again[k].confidence, once[k].confidence);
        }
    }
}

TEST(LkMatcher, NoBlocksGiveNoVectors) {
    Pair pair;
    pair.layout = {};
    pair.predicted_px.clear();
    EXPECT_TRUE(pair.match().empty());
}

}  // namespace
}  // namespace flownav::flow
