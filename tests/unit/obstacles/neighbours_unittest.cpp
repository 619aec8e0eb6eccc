#include <gtest/gtest.h>

#include "flownav/obstacles/classify.h"

namespace flownav::obstacles {
namespace {

using Neighbours = std::vector<std::array<int, 4>>;

Classification candidate(double depth_m) {
    Classification j;
    j.label = BlockLabel::Unsupported;
    j.inverse_depth = 1 / depth_m;
    j.sigma = 0.001;
    j.excess_px = 5.0;
    return j;
}

BlockLabel fate_of_first(std::vector<Classification> judgements,
                         const std::array<int, 4>& neighbours = {1, 2, 3, 4}) {
    Neighbours all(judgements.size(), {-1, -1, -1, -1});
    all[0] = neighbours;
    confirm_by_neighbours(judgements, all, {});
    return judgements[0].label;
}

TEST(Neighbours, TwoOfTheSameDepthConfirmACandidate) {
    EXPECT_EQ(fate_of_first({candidate(2.0), candidate(2.1), candidate(1.9), candidate(9), candidate(9)}),
              BlockLabel::Obstacle);
}

TEST(Neighbours, OneOfTheSameDepthDoesNot) {
    EXPECT_EQ(fate_of_first({candidate(2.0), candidate(2.1), candidate(9), candidate(9), candidate(9)}),
              BlockLabel::Unsupported);
}

TEST(Neighbours, OtherDepthsDoNotConfirm) {
    EXPECT_EQ(fate_of_first({candidate(2), candidate(4), candidate(4), candidate(4), candidate(4)}),
              BlockLabel::Unsupported);
}

TEST(Neighbours, ALonelyCandidateStaysUnsupported) {
    EXPECT_EQ(fate_of_first({candidate(2.0)}, {-1, -1, -1, -1}), BlockLabel::Unsupported);
}

TEST(Neighbours, OnlyCandidatesConfirm) {
    std::vector<Classification> judgements(5, candidate(2.0));
    for (const BlockLabel label : {BlockLabel::Ground, BlockLabel::Eliminated, BlockLabel::Unjudged}) {
        judgements[1].label = judgements[2].label = judgements[3].label = label;
        EXPECT_EQ(fate_of_first(judgements), BlockLabel::Unsupported);
    }
}

TEST(Neighbours, DoNotMakeFloorAnObstacle) {
    std::vector<Classification> judgements(5, candidate(2.0));
    judgements[0].label = BlockLabel::Ground;
    EXPECT_EQ(fate_of_first(judgements), BlockLabel::Ground);
}

TEST(Neighbours, TheOrderOfTheBlocksDoesNotMatter) {
    std::vector<Classification> judgements(4, candidate(2.0));
    const Neighbours all = {{1, 2, 3, -1}, {0, 2, 3, -1}, {0, 1, 3, -1}, {0, 1, 2, -1}};
    confirm_by_neighbours(judgements, all, {});
    for (const Classification& j : judgements) EXPECT_EQ(j.label, BlockLabel::Obstacle);
}

TEST(SimilarDepth, IsWithinFifteenPercentHoweverVagueTheDepthsAre) {
    EXPECT_TRUE(similar_depth(candidate(2.0), candidate(2.3)));
    EXPECT_FALSE(similar_depth(candidate(2.0), candidate(2.4)));
    Classification vague = candidate(4.0);
    vague.sigma = 0.2;
    EXPECT_FALSE(similar_depth(candidate(2.0), vague));
}

}  // namespace
}  // namespace flownav::obstacles
