#include "runner.h"

#include <gtest/gtest.h>

#include "checkpoints.h"
#include "view_samples.h"

namespace flownav::view {
namespace {

using namespace flownav::testing;

TEST(Runner, RunsLikeReplayToTheLastBit) {
    const auto expected = straight_run(corridor());
    Runner runner(corridor(), {});
    for (const pipeline::Step& step : expected) {
        ASSERT_TRUE(runner.advance());
        EXPECT_EQ(fingerprint(runner.frame().step), fingerprint(step));
    }
    EXPECT_FALSE(runner.advance());
    EXPECT_EQ(runner.end().kind, io::ReadEnd::Kind::Clean);
}

TEST(Runner, KnowsWhatEachFieldWasComparedWith) {
    Runner runner(corridor(), {});
    std::optional<double> reference_s;
    while (runner.advance()) {
        const Frame& frame = runner.frame();
        ASSERT_EQ(frame.reference.has_value(), reference_s.has_value());
        if (reference_s) {
            EXPECT_EQ(frame.reference->timestamp_s, *reference_s);
        }
        if (frame.step.end_of_cycle || frame.step.image_of_cycle == 0) reference_s = frame.step.timestamp_s;
    }
    EXPECT_TRUE(reference_s);
}

TEST(Runner, TellsThePosesInFrontOfAField) {
    Runner runner(corridor(), {});
    std::size_t poses = 0;
    while (runner.advance()) poses += runner.poses().size();
    EXPECT_GT(poses, 60U);
}

TEST(Checkpoints, StayInTheirMemoryAndLeadEverywhere) {
    Runner runner(corridor(), {});
    Checkpoints all(1U << 30);
    Checkpoints few(2'000'000);
    do {
        all.add(runner.checkpoint());
        few.add(runner.checkpoint());
    } while (runner.advance());
    EXPECT_EQ(all.size(), 8U) << "of 60 fields every eighth";
    EXPECT_LE(few.bytes(), 2'000'000U);
    EXPECT_LT(few.size(), all.size());
    EXPECT_GT(few.stride(), all.stride());
    for (std::size_t index = 0; index < 60; ++index) {
        ASSERT_NE(few.before(index), nullptr);
        EXPECT_LE(few.before(index)->next_index, index);
        EXPECT_GT(few.before(index)->next_index + few.stride(), index);
    }
    EXPECT_EQ(Checkpoints(100).before(3), nullptr);
}

}  // namespace
}  // namespace flownav::view
