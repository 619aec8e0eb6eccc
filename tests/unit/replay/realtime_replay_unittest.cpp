#include "flownav/replay/realtime_replay.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flownav::replay {
namespace {

/// A clock that advances by waiting and working only.
struct FakeClock {
    double now_s = 100.0;
    PaceClock clock() {
        return {[this] { return now_s; },
                [this](double time_s) {
                    EXPECT_GT(time_s, now_s);
                    now_s = time_s;
                }};
    }
};

PacedFields run(std::uint64_t count, double work_s, std::vector<std::uint64_t>& worked) {
    const RepeatedTimes times({5.0, 6.0, 7.0, 8.0});
    FakeClock clock;
    return replay_paced(times, count, clock.clock(), [&](std::uint64_t n) {
        worked.push_back(n);
        clock.now_s += work_s;
    });
}

TEST(PacedRun, AFastChainTakesEveryFieldWithTheLatencyOfItsWork) {
    std::vector<std::uint64_t> worked;
    const PacedFields fields = run(6, 0.25, worked);
    EXPECT_EQ(worked, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(fields.arrived, 6U);
    EXPECT_EQ(fields.dropped, 0U);
    EXPECT_EQ(fields.latencies_s, std::vector<double>(6, 0.25));
}

TEST(PacedRun, ASlowChainDropsTheOlderFieldAndTakesTheNewest) {
    std::vector<std::uint64_t> worked;
    const PacedFields fields = run(7, 2.5, worked);
    // At 2.5, fields 1 and 2 wait: takes 2 until 5.0. Field 5 has just arrived: takes 5 until 7.5, then 6.
    EXPECT_EQ(worked, (std::vector<std::uint64_t>{0, 2, 5, 6}));
    EXPECT_EQ(fields.arrived, 7U);
    EXPECT_EQ(fields.dropped, 3U);
    EXPECT_EQ(fields.latencies_s, (std::vector<double>{2.5, 3.0, 2.5, 4.0}));
}

TEST(PacedRun, AFieldThatWaitsAloneIsNotDropped) {
    std::vector<std::uint64_t> worked;
    const PacedFields fields = run(3, 1.5, worked);
    EXPECT_EQ(worked, (std::vector<std::uint64_t>{0, 1, 2}));
    EXPECT_EQ(fields.dropped, 0U);
    EXPECT_EQ(fields.latencies_s, (std::vector<double>{1.5, 2.0, 2.5}));
}

TEST(RepeatedTimes, RiseFromRoundToRound) {
    const RepeatedTimes times({5.0, 6.0, 8.0});
    EXPECT_DOUBLE_EQ(times.once_s(), 4.5);  // the mean period is 1.5 s
    EXPECT_DOUBLE_EQ(times.after_start_s(2), 3.0);
    EXPECT_DOUBLE_EQ(times.after_start_s(3), 4.5);
    EXPECT_DOUBLE_EQ(times.after_start_s(7), 10.0);
    EXPECT_EQ(times.field(7), 1U);
}

TEST(RepeatedTimes, CountWhatComesWithinADuration) {
    const RepeatedTimes times({5.0, 6.0, 8.0});
    EXPECT_EQ(times.count_within(times.once_s()), 3U);
    EXPECT_EQ(times.count_within(4.6), 4U);
    EXPECT_EQ(times.count_within(0.5), 1U);
}

TEST(RepeatedTimes, NeedTwoFields) {
    EXPECT_THROW(RepeatedTimes({1.0}), std::invalid_argument);
    EXPECT_THROW(RepeatedTimes({1.0, 1.0, 1.0}), std::invalid_argument);
}

TEST(LatencyFigures, AreTheNearestRanksOfKnownSamples) {
    std::vector<double> samples_s;
    for (int i = 2000; i >= 1; --i) samples_s.push_back(i);
    const LatencyFigures figures = latency_figures(samples_s);
    EXPECT_EQ(figures.median_s, 1000);
    EXPECT_EQ(figures.p99_s, 1980);
    EXPECT_EQ(figures.p999_s, 1998);
    EXPECT_EQ(figures.worst_s, 2000);
}

TEST(LatencyFigures, OfOneSampleAreThatSample) {
    const LatencyFigures figures = latency_figures({3.0});
    EXPECT_EQ(figures.median_s, 3.0);
    EXPECT_EQ(figures.p999_s, 3.0);
    EXPECT_EQ(latency_figures({}).worst_s, 0.0);
}

}  // namespace
}  // namespace flownav::replay
