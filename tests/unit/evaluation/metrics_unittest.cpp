#include "flownav/evaluation/metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flownav/math/units.h"
#include "step_samples.h"

namespace flownav::evaluation {
namespace {

constexpr int fields = 101;

/// A recorded track with these rates, sampled at the fields, in another frame.
PoseTrack track_of(double omega_radps, double v_mps, int samples = fields) {
    const Pose2 T_world_start = {10.0, -5.0, 2.5};
    PoseTrack track;
    for (int i = 0; i < samples; ++i) {
        const Pose2 pose = compose(T_world_start, testing::step_at(i, omega_radps, v_mps).T_start_robot);
        track.add(testing::start_s + i * testing::period_s, {pose.x_m, pose.y_m, 0, pose.yaw_rad, 0, 0});
    }
    track.finish();
    return track;
}

std::vector<FieldRow> rows_of(double omega_radps, double v_mps) {
    std::vector<FieldRow> rows;
    rows.reserve(fields);
    for (int i = 0; i < fields; ++i) rows.push_back(row_of(testing::step_at(i, omega_radps, v_mps)));
    return rows;
}

TEST(Metrics, TheTruthItselfHasNoErrors) {
    const Errors errors = compare(rows_of(0.2, 0.4), track_of(0.2, 0.4));
    EXPECT_EQ(errors.fields_compared, 101U);
    EXPECT_NEAR(errors.path_m.value(), 100 * 0.4 * testing::period_s, 1e-9);
    EXPECT_NEAR(errors.omega_rms_degps.value(), 0.0, 1e-6);
    EXPECT_NEAR(errors.omega_cycle_rms_degps.value(), 0.0, 1e-6);
    // The chord of a cycle is shorter than the sum of its four chords by a term in (omega dt)^2.
    EXPECT_NEAR(errors.v_bias_percent.value(), 0.0, 0.01);
    EXPECT_NEAR(errors.v_sd_percent.value(), 0.0, 1e-6);
    EXPECT_NEAR(errors.t_measured_percent.value(), 100.0, 1e-9);
    EXPECT_NEAR(errors.end_position_percent.value(), 0.0, 1e-9);
    EXPECT_NEAR(errors.heading_end_deg.value(), 0.0, 1e-9);
}

TEST(Metrics, AConstantErrorOfTheTurnRateIsItsRmsAndAddsUpInTheHeading) {
    const Errors errors = compare(rows_of(0.2 + 0.01, 0.4), track_of(0.2, 0.4));
    const double error_degps = deg(0.01);
    EXPECT_NEAR(errors.omega_rms_degps.value(), error_degps, 1e-6);
    EXPECT_NEAR(errors.omega_cycle_rms_degps.value(), error_degps, 1e-6);
    EXPECT_NEAR(errors.heading_end_deg.value(), error_degps * 4.0, 1e-6);
    EXPECT_GT(errors.end_position_percent.value(), 0.5);
}

TEST(Metrics, AnAlternatingErrorOfTheTurnRateVanishesOverACycle) {
    auto rows = rows_of(0.2, 0.4);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].omega_radps += i % 2 == 0 ? 0.01 : -0.01;
    const Errors errors = compare(rows, track_of(0.2, 0.4));
    EXPECT_NEAR(errors.omega_rms_degps.value(), deg(0.01), 1e-6);
    // Two fields count of the cycle in which settling ends; their errors cancel too.
    EXPECT_NEAR(errors.omega_cycle_rms_degps.value(), 0.0, 1e-6);
}

TEST(Metrics, ASpeedTwoPercentTooHighIsItsBias) {
    const Errors errors = compare(rows_of(0.0, 0.408), track_of(0.0, 0.4));
    EXPECT_NEAR(errors.v_bias_percent.value(), 2.0, 1e-6);
    EXPECT_NEAR(errors.v_sd_percent.value(), 0.0, 1e-6);
    EXPECT_NEAR(errors.end_position_percent.value(), 2.0, 1e-6);
}

TEST(Metrics, TheFirstFieldsAreLeftOutOfTheRatesOnly) {
    auto rows = rows_of(0.2, 0.4);
    for (std::size_t i = 0; i <= Errors::settling_fields; ++i) rows[i].omega_radps = 5.0;
    EXPECT_NEAR(compare(rows, track_of(0.2, 0.4)).omega_rms_degps.value(), 0.0, 1e-6);
    rows[Errors::settling_fields + 1].omega_radps = 5.0;
    EXPECT_GT(compare(rows, track_of(0.2, 0.4)).omega_rms_degps.value(), 1.0);
}

TEST(Metrics, FieldsThatMeasuredNothingAreLeftOutOfTheRates) {
    auto rows = rows_of(0.2, 0.4);
    rows[50].status = FieldStatus::Lost;
    rows[50].omega_radps = 5.0;
    EXPECT_NEAR(compare(rows, track_of(0.2, 0.4)).omega_rms_degps.value(), 0.0, 1e-6);
}

TEST(Metrics, HalfOfTheCyclesMeasuredIsFiftyPercent) {
    auto rows = rows_of(0.2, 0.4);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i % 8 == 0) rows[i].v_measured = false;
    }
    const double percent = compare(rows, track_of(0.2, 0.4)).t_measured_percent.value();
    EXPECT_NEAR(percent, 50.0, 3.0);
}

TEST(Metrics, WithoutCommonTimeThereAreNoFigures) {
    PoseTrack other;
    other.add(5.0, {});
    other.add(6.0, {});
    other.finish();
    const Errors errors = compare(rows_of(0.2, 0.4), other);
    EXPECT_EQ(errors.fields_compared, 0U);
    for (const Figure& figure : error_figures())
        EXPECT_FALSE((errors.*figure.value).has_value()) << figure.name;
}

TEST(Metrics, ARobotThatStandsHasNoRelativeFigures) {
    const Errors errors = compare(rows_of(0.0, 0.0), track_of(0.0, 0.0));
    EXPECT_FALSE(errors.end_position_percent.has_value());
    EXPECT_FALSE(errors.v_bias_percent.has_value());
    EXPECT_NEAR(errors.heading_end_deg.value(), 0.0, 1e-9);
}

TEST(Metrics, TruthThatEndsEarlyIsComparedAsFarAsItGoes) {
    const Errors errors = compare(rows_of(0.2, 0.4), track_of(0.2, 0.4, 51));
    EXPECT_EQ(errors.fields_compared, 51U);
    EXPECT_NEAR(errors.end_position_percent.value(), 0.0, 1e-9);
}

TEST(PoseTrack, InterpolatesPositionsAndTakesTheShortWayRound) {
    PoseTrack track;
    track.add(2.0, {2.0, 0.0, 0.0, -3.0, 0.0, 0.0});
    track.add(1.0, {0.0, 1.0, 0.0, 3.0, 0.0, 0.0});
    track.finish();
    const Pose2 pose = track.ground_at(1.5).value();
    EXPECT_NEAR(pose.x_m, 1.0, 1e-12);
    EXPECT_NEAR(pose.y_m, 0.5, 1e-12);
    EXPECT_NEAR(std::abs(pose.yaw_rad), M_PI, 1e-9);
    EXPECT_FALSE(track.at(0.9).has_value());
    EXPECT_FALSE(track.at(2.1).has_value());
    EXPECT_TRUE(track.at(2.0).has_value());
}

TEST(PoseTrack, AlignedStartsWithTheIdentityAtTheGivenTime) {
    PoseTrack track;
    track.add(1.0, {1.0, 0.0, 0.0, M_PI / 2, 0.0, 0.0});
    track.add(2.0, {1.0, 2.0, 0.0, M_PI / 2, 0.0, 0.0});
    track.finish();
    const auto poses = track.aligned(1.5);
    ASSERT_EQ(poses.size(), 2U);
    EXPECT_EQ(poses[0].timestamp_s, 1.5);
    EXPECT_NEAR(poses[0].pose.x, 0.0, 1e-12);
    EXPECT_NEAR(poses[0].pose.yaw, 0.0, 1e-12);
    EXPECT_EQ(poses[1].timestamp_s, 2.0);
    EXPECT_NEAR(poses[1].pose.x, 1.0, 1e-9) << "ahead";
    EXPECT_NEAR(poses[1].pose.y, 0.0, 1e-9);
}

TEST(PoseTrack, AlignedBeginsWithItsOwnFirstSampleWhenItBeginsLater) {
    PoseTrack track;
    track.add(3.0, {5.0, 5.0, 0.0, 1.0, 0.0, 0.0});
    track.finish();
    const auto poses = track.aligned(1.0);
    ASSERT_EQ(poses.size(), 1U);
    EXPECT_EQ(poses[0].timestamp_s, 3.0);
    EXPECT_NEAR(poses[0].pose.x, 0.0, 1e-12);
    EXPECT_TRUE(track.aligned(4.0).empty());
}

}  // namespace
}  // namespace flownav::evaluation
