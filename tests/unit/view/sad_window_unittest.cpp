#include "sad_window.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "flownav/sim/random.h"
#include "view_samples.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;
using Eigen::Vector2i;

constexpr int edge_px = 16;  // edge of a block
constexpr int low = -8;      // mu and nu range from low to high
constexpr int high = 7;
constexpr int width_px = 96;
constexpr int height_px = 80;

/// Grey value of an irregular pattern, 40..199, at an integer point.
int grey_at(int u, int v) {
    const auto x = static_cast<std::uint64_t>(u);
    const auto y = static_cast<std::uint64_t>(v);
    return 40 + static_cast<int>(sim::mix(x, y) % 160);
}

/// The pattern, moved right and down by `shift_px` and brightened by `brighter` grey levels.
Field field_of(double timestamp_s, const Vector2i& shift_px = Vector2i::Zero(), int brighter = 0) {
    auto image = std::make_shared<GreyImage>(width_px, height_px);
    for (int v = 0; v < height_px; ++v) {
        for (int u = 0; u < width_px; ++u) {
            const int grey = grey_at(u - shift_px.x(), v - shift_px.y()) + brighter;
            image->row(v)[u] = static_cast<std::uint8_t>(grey);
        }
    }
    return {timestamp_s, image->view(), standard_camera(width_px, height_px), image};
}

/// A frame with blocks at these corners and predictions of `predicted_px`.
Frame frame_of(const Vector2i& shift_px, const std::vector<Vector2i>& corners_px,
               const Eigen::Vector2d& predicted_px, int brighter = 0) {
    Frame frame;
    frame.reference = field_of(1.0);
    frame.field = field_of(1.04, shift_px, brighter);
    frame.step.image_of_cycle = 1;
    for (const Vector2i& corner_px : corners_px) {
        pipeline::BlockRecord block;
        block.vector.at_px = corner_px.cast<double>().array() + 7.5;
        block.predicted_px = predicted_px;
        frame.step.blocks.push_back(block);
    }
    return frame;
}

flow::FlowParams constant_brightness() {
    flow::FlowParams params;
    params.brightness = flow::BrightnessModel::Constant;
    return params;
}

/// Eq. (2), pixel by pixel; empty when the displaced block leaves the newer image.
std::optional<int> sum_of_differences(const ImageView& reference, const ImageView& newer,
                                      const Vector2i& corner_px, const Vector2i& displacement_px) {
    const Vector2i at = corner_px + displacement_px;
    if (at.minCoeff() < 0 || at.x() + edge_px > newer.width_px || at.y() + edge_px > newer.height_px)
        return {};
    int sum = 0;
    for (int v = 0; v < edge_px; ++v) {
        for (int u = 0; u < edge_px; ++u) {
            const int there = newer.at(at.x() + u, at.y() + v);
            sum += std::abs(reference.at(corner_px.x() + u, corner_px.y() + v) - there);
        }
    }
    return sum;
}

/// The window's cost of an offset; empty for `no_cost`.
std::optional<int> cost_of(const SadWindow& window, const Vector2i& offset) {
    const auto cost = window.surface.at(static_cast<std::size_t>(16 * (offset.y() - low) + offset.x() - low));
    return cost == flow::no_cost ? std::nullopt : std::optional<int>(cost);
}

/// Compares every cost of the window with the sums over the two images.
void expect_true_costs(const SadWindow& window, const Frame& frame, const Vector2i& corner_px,
                       const Vector2i& bias_px) {
    for (int nu = low; nu <= high; ++nu) {
        for (int mu = low; mu <= high; ++mu) {
            const Vector2i offset(mu, nu);
            EXPECT_EQ(cost_of(window, offset), sum_of_differences(frame.reference->image, frame.field.image,
                                                                  corner_px, bias_px + offset))
                << "mu " << mu << ", nu " << nu;
        }
    }
}

TEST(SadWindow, MuCountsToTheRightAndNuDown) {
    for (const Vector2i& shift_px :
         {Vector2i(5, 0), Vector2i(-5, 0), Vector2i(0, 3), Vector2i(0, -3), Vector2i(-8, 7)}) {
        const Frame frame = frame_of(shift_px, {{40, 32}}, {0.0, 0.0});
        const auto window = sad_window(frame, 0, constant_brightness());
        ASSERT_TRUE(window);
        EXPECT_EQ(window->match.mu, shift_px.x());
        EXPECT_EQ(window->match.nu, shift_px.y());
        EXPECT_EQ(window->match.minimum, 0);
    }
}

TEST(SadWindow, EveryCostIsTheSumOfAbsoluteDifferencesAboutThePredictedFlow) {
    const Frame frame = frame_of({6, -9}, {{40, 40}}, {3.4, -6.6});
    const auto window = sad_window(frame, 0, constant_brightness());
    ASSERT_TRUE(window);
    EXPECT_EQ(window->corner_px, Vector2i(40, 40));
    EXPECT_EQ(window->bias_px, Vector2i(3, -7));
    EXPECT_EQ(window->match.mu, 3);
    EXPECT_EQ(window->match.nu, -2);
    expect_true_costs(*window, frame, {40, 40}, {3, -7});
}

TEST(SadWindow, OffsetsThatLeaveTheImageHaveNoCost) {
    const std::vector<Vector2i> corners_px = {{3, 30}, {76, 30}, {40, 2}, {40, 60}};
    const Frame frame = frame_of({1, 1}, corners_px, {0.0, 0.0});
    for (std::size_t i = 0; i < corners_px.size(); ++i) {
        const auto window = sad_window(frame, i, constant_brightness());
        ASSERT_TRUE(window);
        expect_true_costs(*window, frame, corners_px[i], {0, 0});
    }
    const flow::SearchRange left = sad_window(frame, 0, constant_brightness())->range;
    EXPECT_EQ(left.mu_min, -3);
    EXPECT_EQ(left.mu_max, high);
    const flow::SearchRange bottom = sad_window(frame, 3, constant_brightness())->range;
    EXPECT_EQ(bottom.nu_min, low);
    EXPECT_EQ(bottom.nu_max, height_px - edge_px - 60);
}

TEST(SadWindow, TheSecondMinimumIsTheLeastOneAtLeastThreePixelsAway) {
    for (const Vector2i& shift_px : {Vector2i(5, -4), Vector2i(-6, 2)}) {
        const Frame frame = frame_of(shift_px, {{40, 32}}, {0.0, 0.0});
        const auto window = sad_window(frame, 0, constant_brightness());
        ASSERT_TRUE(window);
        int least = 1 << 30;
        Vector2i where(0, 0);
        for (int nu = low; nu <= high; ++nu) {
            for (int mu = low; mu <= high; ++mu) {
                if ((Vector2i(mu, nu) - shift_px).cwiseAbs().maxCoeff() < 3) continue;
                const int cost =
                    *sum_of_differences(frame.reference->image, frame.field.image, {40, 32}, {mu, nu});
                if (cost >= least) continue;
                least = cost;
                where = {mu, nu};
            }
        }
        EXPECT_EQ(window->match.second, least);
        EXPECT_EQ(window->second, where);
    }
}

TEST(SadWindow, ABrighterImageIsComparedAfterItsBrightness) {
    const std::vector<Vector2i> corners_px = {{10, 10}, {30, 10}, {50, 10}, {10, 40}, {30, 40}, {50, 40}};
    for (const int brighter : {12, -12}) {
        const Frame frame = frame_of({2, 1}, corners_px, {2.0, 1.0}, brighter);
        const auto window = sad_window(frame, 4, {});
        ASSERT_TRUE(window);
        EXPECT_NEAR(window->brightness.gain, 1.0, 0.01);
        EXPECT_NEAR(window->brightness.offset, brighter, 1.0);
        EXPECT_LE(window->match.minimum, edge_px * edge_px) << "a grey level a pixel";
        EXPECT_EQ(window->match.mu, 0);
        EXPECT_EQ(window->match.nu, 0);
        const auto uncompensated = sad_window(frame, 4, constant_brightness());
        EXPECT_EQ(cost_of(*uncompensated, {0, 0}), std::abs(brighter) * edge_px * edge_px);
    }
}

TEST(SadWindow, TheVectorsOfARecordingAreTheMinimaOfTheirSums) {
    config::Config config;
    config.pipeline.flow.subpixel = flow::Subpixel::None;
    config.pipeline.flow.brightness = flow::BrightnessModel::Constant;
    Runner runner(corridor(), config);
    int compared = 0;
    while (runner.advance() && runner.next_index() < 40) {
        const Frame& frame = runner.frame();
        if (frame.step.image_of_cycle == 0 || frame.index % 5 != 0) continue;
        for (std::size_t i = 0; i < frame.step.blocks.size(); i += 5) {
            const pipeline::BlockRecord& block = frame.step.blocks[i];
            if (!block.vector.valid || !block.fresh) continue;
            const auto window = sad_window(frame, i, config.pipeline.flow);
            ASSERT_TRUE(window);
            const Vector2i corner_px = (block.vector.at_px.array() - 7.5).cast<int>();
            const Vector2i bias_px = block.predicted_px.array().round().cast<int>();
            expect_true_costs(*window, frame, corner_px, bias_px);
            const Vector2i flow_px = block.vector.flow_px.cast<int>();
            EXPECT_EQ(window->match.minimum,
                      sum_of_differences(frame.reference->image, frame.field.image, corner_px, flow_px));
            EXPECT_EQ(Vector2i(window->match.mu, window->match.nu), flow_px - bias_px);
            ++compared;
        }
    }
    EXPECT_GT(compared, 100);
}

TEST(SadWindow, IsAbsentWhereNothingWasCompared) {
    Frame frame = frame_of({0, 0}, {{40, 32}}, {0.0, 0.0});
    EXPECT_TRUE(sad_window(frame, 0, {}));
    EXPECT_FALSE(sad_window(frame, 1, {})) << "no such block";
    frame.step.image_of_cycle = 0;
    EXPECT_FALSE(sad_window(frame, 0, {})) << "a reference";
    frame.step.image_of_cycle = 1;
    frame.reference.reset();
    EXPECT_FALSE(sad_window(frame, 0, {})) << "the first field";
    EXPECT_FALSE(sad_window(frame_of({0, 0}, {{40, 32}}, {200.0, 0.0}), 0, {})) << "outside the image";
}

}  // namespace
}  // namespace flownav::view
