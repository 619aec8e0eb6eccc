#include <gtest/gtest.h>

#include "drives.h"

namespace flownav {
namespace {

using pipeline::Step;
using testing::cycles_of;
using testing::DriveOptions;

/// Small images: these tests check sequences, not accuracy.
std::vector<Field> small_fields(int images, double v_mps = 0.4) {
    DriveOptions options;
    options.images = images;
    options.v_mps = v_mps;
    options.camera = testing::standard_camera(320, 240);
    return render_fields(testing::drive(options));
}

TEST(Cycles, TheFirstFieldWaits) {
    const Step first = testing::run(small_fields(2)).front();
    EXPECT_EQ(first.status, FieldStatus::Waiting);
    EXPECT_FALSE(first.restarted);
    EXPECT_EQ(first.image_of_cycle, 0);
    EXPECT_FALSE(first.end_of_cycle);
    EXPECT_EQ(first.T_start_robot.x_m, 0.0);
}

TEST(Cycles, HaveTheNumberOfImagesTheyAreGiven) {
    const auto steps = testing::run(small_fields(7), cycles_of(3));
    const int expected[] = {0, 1, 2, 3, 1, 2, 3};
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_EQ(steps[i].image_of_cycle, expected[i]);
        EXPECT_EQ(steps[i].end_of_cycle, expected[i] == 3);
    }
}

TEST(Cycles, OfOneImageEndWithEveryField) {
    const auto steps = testing::run(small_fields(4), cycles_of(1));
    for (std::size_t i = 1; i < steps.size(); ++i) {
        EXPECT_EQ(steps[i].image_of_cycle, 1);
        EXPECT_TRUE(steps[i].end_of_cycle);
    }
}

TEST(Cycles, AreChosenFromTheSpeed) {
    // 16 mm per image; a cycle aims at 80 mm.
    EXPECT_EQ(testing::run(small_fields(3, 0.4)).back().cycle_images, 5);
    EXPECT_EQ(testing::run(small_fields(3, 0.8)).back().cycle_images, 3);
    EXPECT_EQ(testing::run(small_fields(3, 0.0)).back().cycle_images, 12);  // 0.48 s
}

TEST(Cycles, SpeedCountsAsMeasuredOnlyAtTheirEnd) {
    int ends = 0;
    for (const Step& step : testing::run(small_fields(9), cycles_of(4))) {
        EXPECT_EQ(step.v_measured, step.end_of_cycle);
        ends += step.end_of_cycle;
    }
    EXPECT_EQ(ends, 2);
}

TEST(Cycles, ObstaclesAndFloorComeOnlyAtTheirEnd) {
    for (const Step& step : testing::run(small_fields(6), cycles_of(4))) {
        EXPECT_TRUE(step.obstacles.empty());
        EXPECT_EQ(step.ground.empty(), !step.end_of_cycle);
    }
}

TEST(Cycles, ABlockKeepsItsLastGoodVectorOfTheCycle) {
    const auto steps = testing::run(small_fields(5), cycles_of(5));
    int kept = 0;
    for (const pipeline::BlockRecord& block : steps.back().blocks) {
        EXPECT_EQ(block.fresh, block.image_of_cycle == 4);
        kept += !block.fresh && block.image_of_cycle > 0;
    }
    EXPECT_GT(kept, 0);
}

TEST(Cycles, CountsAreThoseOfTheBlocks) {
    for (const Step& step : testing::run(small_fields(5), cycles_of(4))) {
        pipeline::BlockCounts counts;
        for (const pipeline::BlockRecord& block : step.blocks) {
            counts.confident += block.fresh;
            counts.ground += block.label == BlockLabel::Ground;
            counts.obstacle += block.label == BlockLabel::Obstacle;
            counts.eliminated += block.label == BlockLabel::Eliminated;
        }
        if (step.image_of_cycle == 0) continue;
        EXPECT_EQ(counts.confident, step.counts.confident);
        EXPECT_EQ(counts.ground, step.counts.ground);
        EXPECT_EQ(counts.obstacle, step.counts.obstacle);
        EXPECT_EQ(counts.eliminated, step.counts.eliminated);
        EXPECT_LE(step.counts.confident, step.counts.placed);
        EXPECT_LE(step.counts.inliers, step.counts.confident);
    }
}

TEST(Restart, AGapBeginsANewChainAtTheOldPlace) {
    std::vector<Field> fields = small_fields(8);
    for (std::size_t i = 4; i < fields.size(); ++i) fields[i].timestamp_s += 2.0;
    const auto steps = testing::run(fields, cycles_of(3));
    EXPECT_EQ(steps[4].status, FieldStatus::Waiting);
    EXPECT_TRUE(steps[4].restarted);
    EXPECT_EQ(steps[4].image_of_cycle, 0);
    EXPECT_EQ(steps[4].T_start_robot.x_m, steps[3].T_start_robot.x_m);
    EXPECT_EQ(steps[5].image_of_cycle, 1);
    EXPECT_EQ(steps[5].status, FieldStatus::Ok);
    EXPECT_FALSE(steps[5].restarted);
    EXPECT_NEAR(steps[6].v_mps, 0.4, 0.04);
}

TEST(Restart, APauseWithinTheLimitDoesNot) {
    std::vector<Field> fields = small_fields(3, 0.0);
    fields[2].timestamp_s += 0.4;
    EXPECT_FALSE(testing::run(fields, cycles_of(3)).back().restarted);
}

TEST(Restart, AnotherImageSizeBeginsANewChain) {
    std::vector<Field> fields = small_fields(3);
    DriveOptions smaller;
    smaller.images = 3;
    smaller.camera = testing::standard_camera(240, 180);
    for (const Field& field : render_fields(testing::drive(smaller)))
        fields.push_back(testing::delayed(field, 3 * 0.04));
    const auto steps = testing::run(fields, cycles_of(4));
    EXPECT_TRUE(steps[3].restarted);
    EXPECT_EQ(steps[3].status, FieldStatus::Waiting);
    EXPECT_FALSE(steps[4].restarted);
    EXPECT_EQ(steps[5].image_of_cycle, 2);
    for (const pipeline::BlockRecord& block : steps[5].blocks) EXPECT_LT(block.vector.at_px.x(), 240.0);
}

TEST(Restart, AnImageTooSmallForABlockIsHandledWithoutBlocks) {
    DriveOptions options;
    options.images = 3;
    options.camera = testing::standard_camera(16, 16);
    for (const Step& step : testing::run(render_fields(testing::drive(options)))) {
        EXPECT_NE(step.status, FieldStatus::Ok);
        EXPECT_TRUE(step.obstacles.empty());
    }
}

}  // namespace
}  // namespace flownav
