#include "flownav/regress/comparison.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/regress/comparison_text.h"

namespace flownav::regress {
namespace {

constexpr auto rms = "errors.ground_truth.omega_rms_degps";    // 10 %, lower is better
constexpr auto points = "written.obstacle_points";             // 2 %, no direction is better
constexpr auto fields = "read.fields";                         // must not change
constexpr auto speed_sd = "errors.ground_truth.v_sd_percent";  // lower is better

RawlogResult done(const std::string& id, const Figures& figures, const std::string& ini = "") {
    RawlogResult rawlog{id, Outcome::Done, {}, {}};
    rawlog.result.id = id;
    rawlog.result.program = "flownav-replay 1";
    rawlog.result.setup = "setup";
    rawlog.result.rawlog_sha256 = "of " + id;
    rawlog.result.ini = ini;
    rawlog.result.figures = figures;
    return rawlog;
}

RawlogResult failed(const std::string& id, const std::string& reason, const Figures& figures = {}) {
    RawlogResult rawlog = done(id, figures);
    rawlog.outcome = Outcome::Failed;
    rawlog.result.status = 2;
    rawlog.result.reason = reason;
    return rawlog;
}

/// Rawlog and figure of each change.
std::vector<std::string> names_of(const Comparison& comparison) {
    std::vector<std::string> names;
    for (const Change& change : comparison.changes) names.push_back(change.id + ' ' + change.figure);
    return names;
}

TEST(Comparison, EqualRunsHaveNoChange) {
    const RunResults run = {done("a", {{rms, 0.04}, {speed_sd, {}}}), failed("b", "ended with status 2")};
    const Comparison comparison = compare(run, run);
    EXPECT_TRUE(comparison.changes.empty());
    EXPECT_TRUE(what_differs(comparison).empty());
    EXPECT_EQ(change_table(comparison, 40), "");
    EXPECT_EQ(tally_text(tally_of(comparison)), "2 rawlogs in both runs: every figure is the same.");
}

TEST(Comparison, AChangeIsMeasuredInTolerances) {
    const Comparison comparison =
        compare({done("a", {{rms, 0.5}, {points, 1000.0}})}, {done("a", {{rms, 0.6}, {points, 990.0}})});
    ASSERT_EQ(comparison.changes.size(), 2U);
    const Change& worse = comparison.changes[0];
    EXPECT_EQ(worse.figure, rms);
    EXPECT_EQ(worse.before, "0.5");
    EXPECT_EQ(worse.after, "0.6");
    EXPECT_EQ(worse.difference, "+0.1 (+20.0 %)");
    EXPECT_NEAR(worse.severity, 2.0, 1e-9);
    EXPECT_NEAR(worse.share.value(), 0.2, 1e-9);
    EXPECT_EQ(worse.verdict, Verdict::Worse);
    EXPECT_NEAR(comparison.changes[1].severity, 0.5, 1e-9);
    EXPECT_EQ(comparison.changes[1].verdict, Verdict::Unknown);
}

TEST(Comparison, WhatMustNotChangeAtAllCountsTenfold) {
    EXPECT_NEAR(severity_of(fields, 30.0, 29.0), 10.0, 1e-9);
    EXPECT_TRUE(std::isfinite(severity_of(points, 0.0, 5.0)));
}

TEST(Comparison, TheWorstIsFirstAndWhatGotBetterIsLast) {
    const Figures before = {{rms, 0.5}, {points, 1000.0}, {speed_sd, 1.0}};
    const Comparison comparison =
        compare({done("a", before), done("b", before), done("c", before)},
                {done("a", {{rms, 0.1}, {points, 1100.0}, {speed_sd, 1.0}}),
                 done("b", {{rms, 0.9}, {points, 1000.0}, {speed_sd, 0.8}}), done("c", before)});
    EXPECT_EQ(names_of(comparison),
              (std::vector<std::string>{std::string("b ") + rms, std::string("a ") + points,
                                        std::string("a ") + rms, std::string("b ") + speed_sd}));
    EXPECT_EQ(comparison.ids, (std::vector<std::string>{"b", "a", "c"}));
}

TEST(Comparison, AFigureThatIsNoLongerKnownIsWorse) {
    const Comparison lost = compare({done("a", {{speed_sd, 1.0}})}, {done("a", {{speed_sd, {}}})});
    ASSERT_EQ(lost.changes.size(), 1U);
    EXPECT_EQ(lost.changes[0].after, "null");
    EXPECT_EQ(lost.changes[0].verdict, Verdict::Worse);
    EXPECT_GT(lost.changes[0].severity, 1.0);
    EXPECT_FALSE(lost.changes[0].share);
    const Comparison found = compare({done("a", {{speed_sd, {}}})}, {done("a", {{speed_sd, 1.0}})});
    EXPECT_EQ(found.changes.at(0).verdict, Verdict::Better);
}

TEST(Comparison, AFigureThatOneProgramDoesNotHaveIsNamed) {
    const Comparison comparison =
        compare({done("a", {{rms, 0.5}})}, {done("a", {{rms, 0.5}, {speed_sd, 1.0}})});
    ASSERT_EQ(comparison.changes.size(), 1U);
    EXPECT_EQ(comparison.changes[0].before, "not there");
    EXPECT_EQ(comparison.changes[0].verdict, Verdict::Unknown);
}

TEST(Comparison, WhereAReplayEndsDifferentlyOnlyThatIsSaid) {
    const Comparison comparison =
        compare({done("a", {{rms, 0.5}}), done("b", {{rms, 0.5}})},
                {failed("a", "took longer than 5 s", {{rms, 0.1}}), done("b", {{rms, 5.0}})});
    EXPECT_EQ(names_of(comparison), (std::vector<std::string>{"a ", std::string("b ") + rms}));
    EXPECT_EQ(comparison.changes[0].after, "failed: took longer than 5 s");
    EXPECT_EQ(comparison.changes[0].verdict, Verdict::Worse);
    EXPECT_NE(change_table(comparison, 40).find("outcome of the replay"), std::string::npos);
}

TEST(Comparison, RecordingsThatFailInBothAreComparedAsTheyAre) {
    const Comparison comparison = compare({failed("a", "ended with status 2", {{fields, 5.0}})},
                                          {failed("a", "ended with status 2", {{fields, 4.0}})});
    EXPECT_EQ(names_of(comparison), (std::vector<std::string>{std::string("a ") + fields}));
}

TEST(Comparison, RawlogsOfOneRunOnlyAreNamed) {
    const RawlogResult missing{"m", Outcome::Missing, {}, {}};
    RawlogResult other = done("b", {});
    other.result.rawlog_sha256 = "another";
    const Comparison comparison =
        compare({done("a", {}), done("b", {}), done("m", {})}, {other, done("c", {}), missing});
    EXPECT_EQ(comparison.ids, (std::vector<std::string>{"b"}));
    EXPECT_EQ(what_differs(comparison),
              (std::vector<std::string>{"only in A: a, m", "only in B: c", "not the same recording: b"}));
}

TEST(Comparison, SettingsThatDifferAreNamedWithTheirDefaults) {
    const std::string both = "[flow]\nconfidence_min = 0.2\n";
    const Comparison comparison =
        compare({done("a", {}, both), done("b", {}, both)},
                {done("a", {}, both + "\n[obstacles]\ntau_px = 2\n"), done("b", {}, both)});
    EXPECT_EQ(what_differs(comparison),
              (std::vector<std::string>{"obstacles.tau_px: 1.25 (default) -> 2 in 1 rawlog"}));
}

TEST(Comparison, AnotherProgramOfTheSameVersionIsNoticed) {
    RawlogResult other = done("a", {});
    other.result.setup = "other";
    EXPECT_EQ(what_differs(compare({done("a", {})}, {other})),
              (std::vector<std::string>{"program: another file, of the same version flownav-replay 1"}));
    other.result.program = "flownav-replay 2";
    EXPECT_EQ(what_differs(compare({done("a", {})}, {other})),
              (std::vector<std::string>{"program: flownav-replay 1 -> flownav-replay 2"}));
}

TEST(Comparison, TheTallyCountsRawlogsBeyondTolerance) {
    const Figures before = {{rms, 0.5}, {points, 1000.0}};
    const Comparison comparison =
        compare({done("a", before), done("b", before), done("c", before), done("d", before)},
                {done("a", {{rms, 0.9}, {points, 1100.0}}), done("b", {{rms, 0.1}, {points, 1000.0}}),
                 done("c", {{rms, 0.51}, {points, 1000.0}}), done("d", before)});
    EXPECT_EQ(
        tally_text(tally_of(comparison)),
        "4 rawlogs in both runs, 3 changed, 2 of them beyond tolerance: 1 worse, 1 better, 1 in figures "
        "of which neither way is better.");
}

TEST(Comparison, TheTableHasColumnsAndAnEnd) {
    const Figures before = {{rms, 0.5}, {points, 1000.0}};
    const Comparison comparison = compare(
        {done("a", before), done("long name", before)},
        {done("a", {{rms, 0.6}, {points, 1000.0}}), done("long name", {{rms, 0.5}, {points, 990.0}})});
    EXPECT_EQ(change_table(comparison, 40),
              "rawlog     figure                                  A    B          change  tolerances\n"
              "a          errors.ground_truth.omega_rms_degps   0.5  0.6  +0.1 (+20.0 %)         2.0  worse\n"
              "long name  written.obstacle_points              1000  990    -10 (-1.0 %)         0.5\n");
    const std::string short_table = change_table(comparison, 1);
    EXPECT_EQ(short_table.find("long name"), std::string::npos);
}

}  // namespace
}  // namespace flownav::regress
