#include "flownav/motion/wheel_track.h"

#include <gtest/gtest.h>

#include <limits>

namespace flownav::motion {
namespace {

constexpr double period_s = 0.05;

/// Readings of a robot that drives an arc at constant speed, from time 0 on.
WheelTrack driven(double v_mps, double omega_radps, int readings = 41) {
    WheelTrack track;
    const Pose2 start{3.0, -1.0, 2.0};
    for (int i = 0; i < readings; ++i) {
        const double time_s = i * period_s;
        const double turn_rad = omega_radps * time_s;
        const double chord =
            turn_rad == 0.0 ? v_mps * time_s : 2 * v_mps / omega_radps * std::sin(turn_rad / 2);
        track.note({time_s, compose(start, along_arc(turn_rad, chord))});
    }
    return track;
}

TEST(WheelTrack, DrivingForwardIsPositiveAndBackwardNegative) {
    const auto forward = driven(0.5, 0.0).between(0.32, 0.71);
    const auto backward = driven(-0.5, 0.0).between(0.32, 0.71);
    ASSERT_TRUE(forward && backward);
    EXPECT_NEAR(chord_m(forward->T_from_to), 0.5 * 0.39, 1e-9);
    EXPECT_NEAR(chord_m(backward->T_from_to), -0.5 * 0.39, 1e-9);
}

TEST(WheelTrack, TurningLeftIsPositiveAndMovesTheRobotToItsLeft) {
    const auto left = driven(0.5, 0.8).between(0.32, 0.71);
    const auto right = driven(0.5, -0.8).between(0.32, 0.71);
    ASSERT_TRUE(left && right);
    EXPECT_NEAR(left->T_from_to.yaw_rad, 0.8 * 0.39, 1e-9);
    EXPECT_NEAR(right->T_from_to.yaw_rad, -0.8 * 0.39, 1e-9);
    EXPECT_NEAR(left->T_from_to.y_m, 0.5 * 0.39 * std::sin(0.8 * 0.39 / 2), 2e-4);
    EXPECT_NEAR(right->T_from_to.y_m, -left->T_from_to.y_m, 2e-4);
}

TEST(WheelTrack, TheErrorGrowsWithWayTurnAndExtrapolation) {
    const WheelTrack track = driven(0.5, 0.8);
    const auto little = track.between(0.5, 0.6);
    const auto much = track.between(0.5, 1.5);
    const auto beyond = track.between(1.5, 2.08);
    const auto inside = track.between(1.4, 1.98);
    ASSERT_TRUE(little && much && beyond && inside);
    EXPECT_NEAR(much->sigma_forward_m, 0.02 * 0.5, 0.002);
    EXPECT_NEAR(much->sigma_turn_rad, 0.03 * 0.8, 0.003);
    EXPECT_LT(little->sigma_forward_m, much->sigma_forward_m);
    EXPECT_GT(beyond->sigma_turn_rad, inside->sigma_turn_rad);
}

TEST(WheelTrack, GoesOnForATenthOfASecondOutsideTheReadingsAndNoFarther) {
    const WheelTrack track = driven(0.5, 0.0);
    const auto just = track.between(1.9, 2.09);
    ASSERT_TRUE(just);
    EXPECT_NEAR(chord_m(just->T_from_to), 0.5 * 0.19, 1e-9);
    EXPECT_TRUE(track.between(-0.09, 0.5));
    EXPECT_FALSE(track.between(1.9, 2.11));
    EXPECT_FALSE(track.between(-0.11, 0.5));
}

TEST(WheelTrack, TellsNothingAcrossAPauseOfTheReadings) {
    WheelTrack track = driven(0.5, 0.0, 11);  // until 0.5 s
    for (int i = 0; i < 11; ++i) track.note({1.5 + i * period_s, {3.0, -1.0, 2.0}});
    EXPECT_TRUE(track.between(0.1, 0.4));
    EXPECT_FALSE(track.between(0.4, 1.6));
    EXPECT_FALSE(track.between(0.7, 1.0));
    EXPECT_TRUE(track.between(1.6, 1.9));
}

TEST(WheelTrack, ForgetsWhatWasBeforeAJumpOfThePose) {
    WheelTrack track = driven(0.5, 0.0);
    for (int i = 1; i <= 10; ++i) track.note({2.0 + i * period_s, {40.0 + 0.025 * i, 0.0, 0.0}});
    EXPECT_FALSE(track.between(1.8, 2.3));
    const auto after = track.between(2.1, 2.4);
    ASSERT_TRUE(after);
    EXPECT_NEAR(chord_m(after->T_from_to), 0.15, 1e-9);
}

TEST(WheelTrack, LeavesOutReadingsThatAreNoNumberOrNotLater) {
    WheelTrack track = driven(0.5, 0.0);
    track.note({std::numeric_limits<double>::quiet_NaN(), {}});
    track.note({2.05, {std::numeric_limits<double>::infinity(), 0.0, 0.0}});
    track.note({1.0, {9.0, 9.0, 0.0}});
    track.note({2.0, {9.0, 9.0, 0.0}});
    EXPECT_EQ(track.newest_s(), 2.0);
    const auto motion = track.between(0.9, 2.0);
    ASSERT_TRUE(motion);
    EXPECT_NEAR(chord_m(motion->T_from_to), 0.55, 1e-9);
}

TEST(WheelTrack, OneReadingAloneTellsNoMotion) {
    WheelTrack track;
    EXPECT_TRUE(track.empty());
    EXPECT_FALSE(track.between(0.0, 0.1));
    track.note({0.0, {}});
    EXPECT_FALSE(track.between(0.0, 0.05));
}

}  // namespace
}  // namespace flownav::motion
