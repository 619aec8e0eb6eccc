#include "flownav/io/event_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

/// Times of events: what is left out, mended, and how it is counted.
namespace flownav::io {
namespace {

using Mode = EventTimes::Mode;

Field image(double time_s) {
    Field field;
    field.timestamp_s = time_s;
    return field;
}

SensorEvent wheels(double time_s) {
    return PoseSample{PoseSample::Source::Odometry, time_s, {}};
}

struct Result {
    std::vector<double> images_s, wheels_s;
    InputCounts counts;

    std::uint64_t rejected(const std::string& reason) const {
        const auto found = counts.rejected.find(reason);
        return found == counts.rejected.end() ? 0 : found->second;
    }
    std::uint64_t mended(const std::string& reason) const {
        const auto found = counts.warnings.find(reason);
        return found == counts.warnings.end() ? 0 : found->second;
    }
};

Result run(const std::vector<SensorEvent>& events, Mode mode = Mode::Recording) {
    Result result;
    EventTimes times(mode);
    const auto drain = [&] {
        while (const auto event = times.pop()) {
            if (const auto* field = std::get_if<Field>(&*event))
                result.images_s.push_back(field->timestamp_s);
            if (const auto* pose = std::get_if<PoseSample>(&*event))
                result.wheels_s.push_back(pose->timestamp_s);
        }
    };
    for (const SensorEvent& event : events) {
        times.push(event, result.counts);
        drain();
    }
    times.finish(result.counts);
    drain();
    return result;
}

/// Images each 40 ms from 100 s on.
std::vector<SensorEvent> steady_images(int count) {
    std::vector<SensorEvent> images;
    for (int i = 0; i < count; ++i) images.emplace_back(image(100.0 + 0.04 * i));
    return images;
}

void expect_rising(const std::vector<double>& times_s) {
    for (std::size_t i = 1; i < times_s.size(); ++i) EXPECT_GT(times_s[i], times_s[i - 1]) << i;
}

double& time_of(SensorEvent& event) {
    return std::get<Field>(event).timestamp_s;
}

TEST(EventTimes, SteadyTimesPassUnchanged) {
    const Result result = run(steady_images(20));
    EXPECT_EQ(result.images_s.size(), 20U);
    EXPECT_DOUBLE_EQ(result.images_s[7], 100.28);
    EXPECT_TRUE(result.counts.rejected.empty());
    EXPECT_TRUE(result.counts.warnings.empty());
}

TEST(EventTimes, JitterAndDroppedImagesPassUnchanged) {
    std::vector<SensorEvent> images;
    for (int i = 0; i < 60; ++i)
        if (i % 3 != 1) images.emplace_back(image(100.0 + 0.04 * i + 0.010 * ((i * 7) % 3 - 1)));
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), images.size());
    EXPECT_TRUE(result.counts.rejected.empty());
    EXPECT_TRUE(result.counts.warnings.empty());
}

TEST(EventTimes, OneStampADayAheadLosesThatImageOnly) {
    for (const std::size_t at : {0U, 1U, 3U, 8U, 19U}) {
        auto images = steady_images(20);
        time_of(images[at]) += 86400.0;
        const Result result = run(images);
        EXPECT_EQ(result.images_s.size(), 19U) << at;
        EXPECT_EQ(result.rejected("time_ahead"), 1U) << at;
        EXPECT_LT(result.images_s.back(), 101.0);
    }
}

TEST(EventTimes, AFewStampsADayAheadLoseThoseImagesOnly) {
    auto images = steady_images(20);
    for (const std::size_t at : {8U, 9U, 10U}) time_of(images[at]) += 86400.0;
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 17U);
    EXPECT_EQ(result.rejected("time_ahead"), 3U);
}

TEST(EventTimes, OneStampADayBehindLosesThatImageOnly) {
    auto images = steady_images(20);
    time_of(images[9]) = 3.0;
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 19U);
    EXPECT_EQ(result.rejected("time_backwards"), 1U);
}

TEST(EventTimes, AClockThatIsSetBackLosesNothing) {
    auto images = steady_images(30);
    for (std::size_t i = 12; i < images.size(); ++i) time_of(images[i]) -= 60.0;
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 30U);
    EXPECT_EQ(result.mended("clock_set_back"), 1U);
    EXPECT_NEAR(result.counts.details.at("clock_set_back_s"), 60.0, 0.01);
    for (std::size_t i = 0; i < 30; ++i)
        EXPECT_NEAR(result.images_s[i], 100.0 + 0.04 * static_cast<double>(i), 1e-6);
}

TEST(EventTimes, WheelsAndImagesAreShiftedByTheSameWhenTheirClockIsSetBack) {
    std::vector<SensorEvent> events;
    for (int i = 0; i < 30; ++i) {
        const double time_s = 100.0 + 0.04 * i - (i < 12 ? 0.0 : 60.0);
        events.emplace_back(image(time_s));
        events.emplace_back(wheels(time_s + 0.015));
    }
    const Result result = run(events);
    ASSERT_EQ(result.images_s.size(), 30U);
    ASSERT_EQ(result.wheels_s.size(), 30U);
    EXPECT_NEAR(result.wheels_s[25] - result.images_s[25], 0.015, 1e-6);
}

TEST(EventTimes, AClockThatIsRightAgainIsBelieved) {
    auto images = steady_images(40);
    for (std::size_t i = 12; i < 24; ++i) time_of(images[i]) -= 50.0;
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 40U);
    EXPECT_NEAR(result.images_s.back(), 100.0 + 0.04 * 39, 1e-6);
    expect_rising(result.images_s);
}

TEST(EventTimes, APauseIsKeptAndCounted) {
    auto images = steady_images(30);
    for (std::size_t i = 12; i < images.size(); ++i) time_of(images[i]) += 100.0;
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 30U);
    EXPECT_NEAR(result.images_s.back(), 200.0 + 0.04 * 29, 1e-6);
    EXPECT_EQ(result.mended("clock_jump"), 1U);
}

TEST(EventTimes, AnImageStampedNearlyAPeriodLateIsLeftOut) {
    auto images = steady_images(20);
    time_of(images[9]) += 0.039;
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 19U);
    EXPECT_EQ(result.rejected("time_too_close"), 1U);
    for (const double time_s : result.images_s) EXPECT_GT(std::abs(time_s - (100.36 + 0.039)), 1e-6);
}

TEST(EventTimes, AnImageStampedNearlyAPeriodEarlyIsLeftOut) {
    auto images = steady_images(20);
    time_of(images[9]) -= 0.039;
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 19U);
    EXPECT_EQ(result.rejected("time_too_close"), 1U);
}

TEST(EventTimes, OfStampsThatComeInPairsOneIsUsed) {
    std::vector<SensorEvent> images;
    for (int i = 0; i < 40; ++i) images.emplace_back(image(100.0 + 0.08 * (i / 2) + 0.001 * (i % 2)));
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 20U);
    EXPECT_EQ(result.rejected("time_too_close"), 20U);
}

TEST(EventTimes, OfNeighboursWithExchangedStampsOneIsUsed) {
    auto images = steady_images(40);
    for (std::size_t i = 0; i + 1 < images.size(); i += 2)
        std::swap(time_of(images[i]), time_of(images[i + 1]));
    const Result result = run(images);
    EXPECT_GE(result.images_s.size(), 20U);
    EXPECT_GE(result.rejected("time_backwards"), 18U);
    expect_rising(result.images_s);
}

TEST(EventTimes, OneStampOffTheBeatLosesThatImageOnly) {
    for (const double off_s : {-0.030, -0.020, 0.015, 0.025, 0.055}) {
        auto images = steady_images(20);
        time_of(images[9]) += off_s;
        const Result result = run(images);
        EXPECT_EQ(result.images_s.size(), 19U) << off_s;
        EXPECT_EQ(result.counts.rejected.size(), 1U) << off_s;
        for (const double time_s : result.images_s) EXPECT_GT(std::abs(time_s - (100.36 + off_s)), 1e-6);
    }
}

TEST(EventTimes, WholeSecondsAreRepeatedTimes) {
    std::vector<SensorEvent> images;
    for (int i = 0; i < 50; ++i) images.emplace_back(image(100.0 + i / 25));
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 2U);
    EXPECT_EQ(result.rejected("time_repeated"), 48U);
}

TEST(EventTimes, NegativeFarAndMissingTimesAreLeftOut) {
    auto images = steady_images(10);
    time_of(images[3]) = -5.0;
    time_of(images[5]) = 5e9;
    time_of(images[7]) = std::numeric_limits<double>::quiet_NaN();
    const Result result = run(images);
    EXPECT_EQ(result.images_s.size(), 7U);
    EXPECT_EQ(result.rejected("time_out_of_range"), 2U);
    EXPECT_EQ(result.rejected("time_invalid"), 1U);
}

TEST(EventTimes, RareImagesAreUsed) {
    std::vector<SensorEvent> images;
    for (int i = 0; i < 10; ++i) images.emplace_back(image(100.0 + 30.0 * i));
    EXPECT_EQ(run(images).images_s.size(), 10U);
}

TEST(EventTimes, EventsOfOtherKindsKeepTheirOrder) {
    std::vector<SensorEvent> events;
    for (int i = 0; i < 8; ++i) {
        events.emplace_back(image(100.0 + 0.04 * i));
        events.emplace_back(wheels(100.0 + 0.04 * i));
    }
    EventTimes times(Mode::Recording);
    InputCounts counts;
    for (const SensorEvent& event : events) times.push(event, counts);
    times.finish(counts);
    for (int i = 0; i < 16; ++i) {
        const auto event = times.pop();
        ASSERT_TRUE(event);
        EXPECT_EQ(std::holds_alternative<Field>(*event), i % 2 == 0);
    }
}

TEST(EventTimes, AHeldEventDoesNotHoldManyImages) {
    EventTimes times(Mode::Recording);
    InputCounts counts;
    times.push(wheels(50.0), counts);
    std::size_t waiting = 0;
    for (int i = 0; i < 100; ++i) {
        times.push(image(100.0 + 0.04 * i), counts);
        ++waiting;
        while (times.pop()) --waiting;
        EXPECT_LT(static_cast<long>(waiting), 20) << i;
    }
}

TEST(EventTimes, ARepeatedFirstStampIsARepeatedOne) {
    auto images = steady_images(20);
    time_of(images[1]) = time_of(images[0]);
    const Result result = run(images);
    EXPECT_EQ(result.rejected("time_repeated"), 1U);
    EXPECT_EQ(result.rejected("time_ahead"), 0U);
}

TEST(EventTimes, ALiveEventIsNeverHeld) {
    EventTimes times(Mode::Live);
    InputCounts counts;
    auto images = steady_images(30);
    time_of(images[5]) += 0.02;
    for (const SensorEvent& event : images) {
        times.push(event, counts);
        EXPECT_TRUE(times.pop());
    }
}

TEST(EventTimes, ALiveClockThatIsSetBackLosesThreeImages) {
    auto images = steady_images(30);
    for (std::size_t i = 12; i < images.size(); ++i) time_of(images[i]) -= 60.0;
    const Result result = run(images, Mode::Live);
    EXPECT_EQ(result.images_s.size(), 27U);
    expect_rising(result.images_s);
}

TEST(EventTimes, OneLiveStampADayAheadLosesThatImageOnly) {
    auto images = steady_images(30);
    time_of(images[12]) += 86400.0;
    const Result result = run(images, Mode::Live);
    EXPECT_EQ(result.images_s.size(), 29U);
    EXPECT_EQ(result.rejected("time_ahead"), 1U);
}

}  // namespace
}  // namespace flownav::io
