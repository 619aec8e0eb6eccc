#include "flownav/motion/gyro_track.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "flownav/sim/random.h"

namespace flownav::motion {
namespace {

constexpr double period_s = 0.01;

/// Readings of a gyro with a bias, from time 0 to 2 s. `rate` tells the true turn rate.
template <class Rate>
GyroTrack turned(const Rate& rate, double bias_radps = 0.0) {
    GyroTrack track;
    for (int i = 0; i <= 200; ++i) track.note({i * period_s, rate(i * period_s) + bias_radps});
    return track;
}

auto constant(double omega_radps) {
    return [omega_radps](double) { return omega_radps; };
}

TEST(GyroTrack, TurningLeftIsPositive) {
    const auto left = turned(constant(0.7)).between(0.313, 0.777);
    const auto right = turned(constant(-0.7)).between(0.313, 0.777);
    ASSERT_TRUE(left && right);
    EXPECT_NEAR(left->omega_rad, 0.7 * 0.464, 1e-12);
    EXPECT_NEAR(right->omega_rad, -0.7 * 0.464, 1e-12);
}

TEST(GyroTrack, IntegratesARateThatChangesBetweenReadings) {
    const auto turn = turned([](double t) { return std::cos(3.0 * t); }).between(0.2041, 1.3333);
    ASSERT_TRUE(turn);
    EXPECT_NEAR(turn->omega_rad, (std::sin(3.0 * 1.3333) - std::sin(3.0 * 0.2041)) / 3.0, 1e-4);
}

TEST(GyroTrack, HoldsTheRateForATenthOfASecondOutsideTheReadingsAndNoFarther) {
    const GyroTrack track = turned(constant(0.7));
    const auto just = track.between(1.9, 2.09);
    ASSERT_TRUE(just);
    EXPECT_NEAR(just->omega_rad, 0.7 * 0.19, 1e-12);
    EXPECT_FALSE(track.between(1.9, 2.11));
    EXPECT_FALSE(track.between(-0.11, 0.3));
}

TEST(GyroTrack, TellsNothingAcrossAPauseOfTheReadings) {
    GyroTrack track = turned(constant(0.7));
    for (int i = 0; i < 20; ++i) track.note({3.0 + i * period_s, 0.7});
    EXPECT_FALSE(track.between(1.9, 3.1));
    EXPECT_FALSE(track.between(2.3, 2.5));
    EXPECT_TRUE(track.between(3.05, 3.15));
}

TEST(GyroTrack, LearnsTheBiasFromTurnsThatAreKnown) {
    sim::Random random(1);
    GyroTrack track = turned(constant(0.3), 0.02);
    const double unsure_rad = track.between(0.0, 0.2)->sigma_rad;
    for (int i = 0; i < 9; ++i)
        track.learn_bias(0.2 * i, 0.2 * (i + 1), 0.3 * 0.2 + random.normal(0.0005), 0.0005);
    EXPECT_NEAR(track.bias_radps(), 0.02, 0.004);
    EXPECT_NEAR(track.between(0.5, 1.5)->omega_rad, 0.3, 0.004);
    EXPECT_LT(track.between(0.0, 0.2)->sigma_rad, 0.5 * unsure_rad);
}

TEST(GyroTrack, AWrongSignIsNotLearntAsABias) {
    GyroTrack track = turned(constant(-0.8));
    for (int i = 0; i < 9; ++i) track.learn_bias(0.2 * i, 0.2 * (i + 1), 0.8 * 0.2, 0.001);
    EXPECT_EQ(track.bias_radps(), 0.0);
}

TEST(GyroTrack, LeavesOutReadingsThatAreNoNumberOrNotLater) {
    GyroTrack track = turned(constant(0.7));
    track.note({2.01, std::numeric_limits<double>::quiet_NaN()});
    track.note({std::numeric_limits<double>::infinity(), 0.7});
    track.note({1.0, 50.0});
    EXPECT_EQ(track.newest_s(), 2.0);
    EXPECT_NEAR(track.between(1.0, 2.0)->omega_rad, 0.7, 1e-12);
}

}  // namespace
}  // namespace flownav::motion
