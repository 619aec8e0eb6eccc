#include <gtest/gtest.h>

#include "flownav/obstacles/judge.h"

namespace flownav {
namespace {

using Neighbours = std::vector<std::array<int, 4>>;

Judgement candidate(double depth_m) {
    Judgement j;
    j.fate = BlockFate::Unsupported;
    j.inverse_depth = 1 / depth_m;
    j.sigma = 0.001;
    j.excess_px = 5.0;
    return j;
}

BlockFate fate_of_first(std::vector<Judgement> judgements,
                        const std::array<int, 4>& neighbours = {1, 2, 3, 4}) {
    Neighbours all(judgements.size(), {-1, -1, -1, -1});
    all[0] = neighbours;
    confirm_by_neighbours(judgements, all, {});
    return judgements[0].fate;
}

TEST(Neighbours, TwoOfTheSameDepthConfirmACandidate) {
    EXPECT_EQ(fate_of_first({candidate(2.0), candidate(2.1), candidate(1.9), candidate(9), candidate(9)}),
              BlockFate::Obstacle);
}

TEST(Neighbours, OneOfTheSameDepthDoesNot) {
    EXPECT_EQ(fate_of_first({candidate(2.0), candidate(2.1), candidate(9), candidate(9), candidate(9)}),
              BlockFate::Unsupported);
}

TEST(Neighbours, OtherDepthsDoNotConfirm) {
    EXPECT_EQ(fate_of_first({candidate(2), candidate(4), candidate(4), candidate(4), candidate(4)}),
              BlockFate::Unsupported);
}

TEST(Neighbours, ALonelyCandidateStaysUnsupported) {
    EXPECT_EQ(fate_of_first({candidate(2.0)}, {-1, -1, -1, -1}), BlockFate::Unsupported);
}

TEST(Neighbours, OnlyCandidatesConfirm) {
    std::vector<Judgement> judgements(5, candidate(2.0));
    for (const BlockFate fate : {BlockFate::Ground, BlockFate::Eliminated, BlockFate::Unjudged}) {
        judgements[1].fate = judgements[2].fate = judgements[3].fate = fate;
        EXPECT_EQ(fate_of_first(judgements), BlockFate::Unsupported);
    }
}

TEST(Neighbours, DoNotMakeFloorAnObstacle) {
    std::vector<Judgement> judgements(5, candidate(2.0));
    judgements[0].fate = BlockFate::Ground;
    EXPECT_EQ(fate_of_first(judgements), BlockFate::Ground);
}

TEST(Neighbours, TheOrderOfTheBlocksDoesNotMatter) {
    std::vector<Judgement> judgements(4, candidate(2.0));
    const Neighbours all = {{1, 2, 3, -1}, {0, 2, 3, -1}, {0, 1, 3, -1}, {0, 1, 2, -1}};
    confirm_by_neighbours(judgements, all, {});
    for (const Judgement& j : judgements) EXPECT_EQ(j.fate, BlockFate::Obstacle);
}

TEST(SimilarDepth, IsWithinFifteenPercentHoweverVagueTheDepthsAre) {
    EXPECT_TRUE(similar_depth(candidate(2.0), candidate(2.3)));
    EXPECT_FALSE(similar_depth(candidate(2.0), candidate(2.4)));
    Judgement vague = candidate(4.0);
    vague.sigma = 0.2;
    EXPECT_FALSE(similar_depth(candidate(2.0), vague));
}

}  // namespace
}  // namespace flownav
