#include "consensus.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/sim/random.h"

namespace flownav::motion {
namespace {

using Eigen::Vector2d;

constexpr int columns = 8;  // grid of the consensus over the image
constexpr int lines = 6;
constexpr int per_cell = 4;

/// The exact equation of a vector at `at` for `turn`: displacement by a unit turn and a unit pitch, in
/// deviations of 0.3 px.
MotionScratch::RotationEquation row_of(const Vector2d& at, const RotationHypothesis& turn) {
    MotionScratch::RotationEquation row;
    row.at = at;
    row.turn = 1600.0 * (1.0 + 0.3 * at.y());
    row.pitch = 1600.0 * (0.2 + at.x());
    row.measured = row.turn * turn.omega_rad + row.pitch * turn.pitch_rad;
    row.weight = 1.0;
    row.deviation_px = 0.3;
    return row;
}

/// Vectors over the whole image, four in each cell; `turn_at(column)` is their rotation.
template <typename TurnAt>
MotionScratch scratch_with(TurnAt turn_at) {
    MotionScratch scratch;
    for (int line = 0; line < lines; ++line) {
        for (int column = 0; column < columns; ++column) {
            for (int i = 0; i < per_cell; ++i) {
                const Vector2d in_cell(i % 2 == 0 ? 0.01 : 0.99, i < 2 ? 0.01 : 0.99);
                const Vector2d at((column + in_cell.x()) / columns - 0.5, (line + in_cell.y()) / lines - 0.5);
                scratch.rotation_equations.push_back(row_of(at, turn_at(column)));
            }
        }
    }
    return scratch;
}

MotionPrediction predicted(double omega_rad, double tolerance_rad = 0.002) {
    MotionPrediction prediction;
    prediction.omega_rad = omega_rad;
    prediction.omega_tolerance_rad = tolerance_rad;
    return prediction;
}

Consensus consensus_of(MotionScratch scratch, const MotionPrediction& prediction,
                       MotionModel model = MotionModel::YawPitch, double background_rad = 0.0) {
    MotionParams params;
    params.model = model;
    prepare_inlier_counts(scratch);
    return find_consensus(scratch, background_rad, prediction, params);
}

void make_wild(MotionScratch& scratch, double share, std::uint64_t seed) {
    sim::HashRandom random(seed);
    for (auto& row : scratch.rotation_equations)
        if (random.uniform(0, 1) < share) row.measured += random.uniform(-60.0, 60.0);
}

void add_noise(MotionScratch& scratch, std::uint64_t seed) {
    sim::HashRandom random(seed);
    for (auto& row : scratch.rotation_equations) row.measured += random.normal(1.0);
}

TEST(Consensus, FindsTurnsToEitherSideAndPitchesUpAndDownAmongWildVectors) {
    for (const double omega_rad : {0.05, -0.05}) {
        for (const double pitch_rad : {0.02, -0.02}) {
            const RotationHypothesis truth{omega_rad, pitch_rad};
            MotionScratch scratch = scratch_with([&](int) { return truth; });
            make_wild(scratch, 0.35, 11);
            const Consensus found = consensus_of(scratch, predicted(0.0));
            EXPECT_NEAR(found.turn.omega_rad, omega_rad, 1e-9);
            EXPECT_NEAR(found.turn.pitch_rad, pitch_rad, 1e-9);
            EXPECT_GT(found.support.share(), 0.45);  // cells in which three of four vectors are right: 0.56
            EXPECT_FALSE(found.as_predicted);
        }
    }
}

TEST(Consensus, StandsNearTheTruthWhenVectorsAreNoisy) {
    for (const double side : {1.0, -1.0}) {
        MotionScratch scratch = scratch_with([&](int) {
            return RotationHypothesis{0.05 * side, -0.01 * side};
        });
        add_noise(scratch, 12);
        make_wild(scratch, 0.3, 13);
        const Consensus found = consensus_of(scratch, predicted(0.0));
        EXPECT_NEAR(found.turn.omega_rad, 0.05 * side, 0.002);  // three standard deviations of one vector
        EXPECT_NEAR(found.turn.pitch_rad, -0.01 * side, 0.004);
    }
}

TEST(Consensus, WithoutPitchInTheModelItIsATurnAlone) {
    for (const double omega_rad : {0.05, -0.05}) {
        MotionScratch scratch = scratch_with([&](int) { return RotationHypothesis{omega_rad, 0.0}; });
        make_wild(scratch, 0.35, 14);
        MotionPrediction prediction = predicted(0.0);
        prediction.pitch_rad = 0.03;
        const Consensus found = consensus_of(scratch, prediction, MotionModel::Yaw);
        EXPECT_NEAR(found.turn.omega_rad, omega_rad, 1e-9);
        EXPECT_EQ(found.turn.pitch_rad, 0.0);
    }
}

TEST(Consensus, WhatFillsMoreOfTheImageWinsOverMoreVectorsOnOneThing) {
    for (const double side : {1.0, -1.0}) {
        MotionScratch scratch = scratch_with([&](int) { return RotationHypothesis{0.03 * side, 0.0}; });
        for (int i = 0; i < 600; ++i) {  // three times as many vectors, all in the cells of one corner
            const Vector2d at(-0.45 + 0.2 * (i % 25) / 25.0, -0.45 + 0.2 * std::floor(i / 25.0) / 24.0);
            scratch.rotation_equations.push_back(row_of(at, {-0.04 * side, 0.0}));
        }
        const Consensus found = consensus_of(scratch, predicted(0.0));
        EXPECT_NEAR(found.turn.omega_rad, 0.03 * side, 1e-9);
    }
}

TEST(Consensus, TheTurnAsPredictedWinsAgainstUpToTwiceItsSupport) {
    for (const double side : {1.0, -1.0}) {
        const RotationHypothesis continued{0.03 * side, 0.0};
        const RotationHypothesis other{-0.05 * side, 0.0};
        for (const int columns_continued : {2, 3}) {  // 12 and 18 of 48 cells
            const MotionScratch scratch =
                scratch_with([&](int column) { return column < columns_continued ? continued : other; });
            const Consensus found = consensus_of(scratch, predicted(continued.omega_rad));
            EXPECT_EQ(found.as_predicted, columns_continued == 3);
            const RotationHypothesis& expected = columns_continued == 3 ? continued : other;
            EXPECT_NEAR(found.turn.omega_rad, expected.omega_rad, 1e-9);
            EXPECT_EQ(found.support.cells, lines * (found.as_predicted ? 3 : 6));
        }
    }
}

TEST(Consensus, OfNoVectorsItIsThePredictionWithoutSupport) {
    for (const double omega_rad : {0.07, -0.07}) {
        MotionPrediction prediction = predicted(omega_rad);
        prediction.pitch_rad = -0.01;
        const Consensus found = consensus_of({}, prediction, MotionModel::YawPitch, 0.2);
        EXPECT_EQ(found.turn.omega_rad, omega_rad);
        EXPECT_EQ(found.turn.pitch_rad, -0.01);
        EXPECT_TRUE(found.as_predicted);
        EXPECT_EQ(found.support.vectors, 0);
        EXPECT_EQ(found.support.share(), 0.0);
    }
}

TEST(Consensus, VectorsThatStandAloneInTheirCellsSupportNothing) {
    const RotationHypothesis truth{0.05, 0.0};
    MotionScratch scratch;
    scratch.rotation_equations = {row_of({-0.5, -0.5}, truth), row_of({0.5, 0.5}, truth)};
    EXPECT_TRUE(consensus_of(scratch, predicted(0.0)).as_predicted) << "nothing speaks against it";
    prepare_inlier_counts(scratch);
    const Support support = support_of(scratch.inlier_counts, truth, 1.0);
    EXPECT_EQ(support.vectors, 2);
    EXPECT_EQ(support.cells, 0);
    EXPECT_EQ(support.all_cells, 0);
}

TEST(Consensus, AVectorAgreesWithinItsErrorOrTheMethodsAndWithinLambda) {
    struct Case {
        double deviations, deviation_px;
        bool agrees;
    };
    for (const Case& c : {Case{2.9, 0.3, true},
                          {3.1, 0.3, false},
                          {3.1, 0.1, true},  // 0.31 px
                          {4.5, 0.1, false},
                          {2.5, 0.5, false}}) {  // 1.25 px
        for (const double sign : {1.0, -1.0}) {
            MotionScratch scratch;
            scratch.rotation_equations = {row_of({0.1, 0.1}, {0.02, 0.01})};
            scratch.rotation_equations[0].deviation_px = c.deviation_px;
            scratch.rotation_equations[0].measured += sign * c.deviations;
            prepare_inlier_counts(scratch);
            EXPECT_EQ(support_of(scratch.inlier_counts, {0.02, 0.01}, 1.0).vectors, c.agrees ? 1 : 0)
                << c.deviations << " deviations of " << c.deviation_px << " px";
        }
    }
}

TEST(Consensus, ACellAgreesWhenMostOfItsVectorsDo) {
    for (const int agreeing : {1, 2, 3}) {
        MotionScratch scratch = scratch_with([](int) { return RotationHypothesis{0.02, 0.0}; });
        for (std::size_t i = 0; i < scratch.rotation_equations.size(); ++i)
            if (static_cast<int>(i) % per_cell >= agreeing) scratch.rotation_equations[i].measured += 50.0;
        prepare_inlier_counts(scratch);
        const Support support = support_of(scratch.inlier_counts, {0.02, 0.0}, 1.0);
        EXPECT_EQ(support.all_cells, columns * lines);
        EXPECT_EQ(support.vectors, agreeing * columns * lines);
        EXPECT_EQ(support.cells, agreeing > 2 ? columns * lines : 0) << agreeing << " of 4";
    }
}

TEST(Consensus, APredictionWithHalfOfAllCellsCannotLoseAgainstAnotherMotion) {
    EXPECT_TRUE(outvotes_every_other_motion({{}, {24, 48, 100}, true}));
    EXPECT_FALSE(outvotes_every_other_motion({{}, {23, 48, 100}, true}));
    EXPECT_FALSE(outvotes_every_other_motion({{}, {0, 0, 0}, true}));
}

}  // namespace
}  // namespace flownav::motion
