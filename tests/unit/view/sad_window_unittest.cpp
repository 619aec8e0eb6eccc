#include "sad_window.h"

#include <gtest/gtest.h>

#include "flownav/flow/subpixel.h"
#include "view_samples.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;

/// Whether the record of a block is about this field, not kept from an earlier one of the cycle.
bool is_of_this_field(const pipeline::BlockRecord& block) {
    return block.vector.valid && (block.fresh || block.image_of_cycle == 0);
}

TEST(SadWindow, ItsMinimumIsTheVectorAndTheConfidenceOfTheMatcher) {
    for (const BrightnessModel brightness : {BrightnessModel::Constant, BrightnessModel::Image}) {
        Config config;
        config.pipeline.flow.subpixel = Subpixel::None;
        config.pipeline.flow.brightness = brightness;
        Runner runner(corridor(), config);
        int compared = 0;
        while (runner.advance()) {
            const Frame& frame = runner.frame();
            if (frame.step.image_of_cycle == 0 || frame.index % 7 != 0) continue;
            for (std::size_t i = 0; i < frame.step.blocks.size(); ++i) {
                const pipeline::BlockRecord& block = frame.step.blocks[i];
                if (!is_of_this_field(block)) continue;
                const auto window = sad_window(frame, i, config.pipeline.flow);
                ASSERT_TRUE(window);
                const Eigen::Vector2i vector(window->bias_px.x() + window->match.mu,
                                             window->bias_px.y() + window->match.nu);
                EXPECT_EQ(vector.cast<double>(), block.vector.flow_px);
                EXPECT_EQ(confidence_of(window->match), block.vector.confidence);
                ++compared;
            }
        }
        EXPECT_GT(compared, 1000);
    }
}

TEST(SadWindow, TheSecondMinimumIsDistinctAndHasTheCostThatWasReported) {
    Runner runner(corridor(), {});
    for (int i = 0; i < 10; ++i) runner.advance();
    for (std::size_t i = 0; i < runner.frame().step.blocks.size(); ++i) {
        const auto window = sad_window(runner.frame(), i, {});
        if (!window || window->match.second == no_cost) continue;
        const Eigen::Vector2i first(window->match.mu, window->match.nu);
        EXPECT_GE((window->second - first).cwiseAbs().maxCoeff(), distinct_px);
        const int at = (window->second.y() - search_min) * search_px + window->second.x() - search_min;
        EXPECT_EQ(window->surface.at(static_cast<std::size_t>(at)), window->match.second);
    }
}

TEST(SadWindow, IsAbsentWhereNothingWasCompared) {
    Runner runner(corridor(), {});
    runner.advance();
    EXPECT_FALSE(sad_window(runner.frame(), 0, {})) << "the first field";
    runner.advance();
    EXPECT_FALSE(sad_window(runner.frame(), 100'000, {})) << "no such block";
}

}  // namespace
}  // namespace flownav::view
