// How far a pose can be relied on, and the motion between two times.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "flownav/pipeline/motion_history.h"
#include "other_sensors.h"
#include "pose_uncertainty.h"
#include "told_drives.h"

namespace flownav {
namespace {

using pipeline::MotionBetween;
using pipeline::MotionHistory;
using pipeline::PoseUncertainty;

MotionHistory arc_to_the_left() {
    MotionHistory history;
    for (int i = 0; i <= 50; ++i) {
        const double time_s = 10.0 + 0.04 * i;
        history.note(
            {time_s, along_arc(0.02 * i, 0.016 * i), 1e-6 * i, 2e-6 * i, i > 40 ? 0.04 * (i - 40) : 0.0});
    }
    return history;
}

TEST(MotionHistory, TellsTheMotionBetweenFieldsAndBetweenTheirTimes) {
    const MotionHistory history = arc_to_the_left();
    const auto motion = history.between(10.4, 11.2);
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->T_from_to.yaw_rad, 0.4, 1e-9);
    EXPECT_NEAR(motion->sigma_m, std::sqrt(20e-6), 1e-9);
    EXPECT_NEAR(motion->sigma_rad, std::sqrt(40e-6), 1e-9);
    EXPECT_EQ(motion->source, MotionSource::Flow);
    EXPECT_NEAR(history.between(10.42, 11.22)->T_from_to.yaw_rad, 0.4, 1e-9);
}

TEST(MotionHistory, TheMotionBackIsTheInverse) {
    const MotionHistory history = arc_to_the_left();
    const Pose2 there = history.between(10.4, 11.2)->T_from_to;
    const Pose2 back = history.between(11.2, 10.4)->T_from_to;
    const Pose2 both = compose(there, back);
    EXPECT_NEAR(both.x_m, 0.0, 1e-12);
    EXPECT_NEAR(both.y_m, 0.0, 1e-12);
    EXPECT_NEAR(both.yaw_rad, 0.0, 1e-12);
}

TEST(MotionHistory, SaysWhenAPartWasCarriedOver) {
    const MotionHistory history = arc_to_the_left();
    EXPECT_EQ(history.between(10.4, 11.6)->source, MotionSource::Flow);
    EXPECT_EQ(history.between(10.4, 11.8)->source, MotionSource::Prediction);
}

TEST(MotionHistory, IsEmptyOutsideTheFields) {
    const MotionHistory history = arc_to_the_left();
    EXPECT_FALSE(history.between(9.9, 11.0));
    EXPECT_FALSE(history.between(10.5, 12.1));
    EXPECT_FALSE(MotionHistory().between(0.0, 0.0));
}

TEST(MotionBetween, OfAPipelineFollowsTheTruthAndBridgesWhatWasCarriedOverByTheWheels) {
    testing::DriveOptions options;
    options.images = 40;
    options.omega_degps = 10.0;
    options.camera = testing::standard_camera(320, 240);
    const testing::Scene scene = testing::drive(options);
    auto fields = render_fields(scene);
    for (std::size_t i = 20; i < 30; ++i)
        fields[i] = testing::without_texture(fields[i], static_cast<unsigned>(i));
    pipeline::State alone{pipeline::Params{}};
    pipeline::State with_wheels{pipeline::Params{}};
    testing::run(alone, fields, scene.poses, {});
    testing::run(with_wheels, fields, scene.poses, {true});
    const auto between = [&](const pipeline::State& state, std::size_t from, std::size_t to) {
        return state.motion_between(fields[from].timestamp_s, fields[to].timestamp_s);
    };
    const Pose2 truth = compose(inverse(scene.poses[2]), scene.poses[18]);
    const auto seen = between(alone, 2, 18);
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->source, MotionSource::Flow);
    EXPECT_NEAR(seen->T_from_to.x_m, truth.x_m, 0.01);
    EXPECT_NEAR(seen->T_from_to.y_m, truth.y_m, 0.01);
    EXPECT_NEAR(seen->T_from_to.yaw_rad, truth.yaw_rad, 0.01);
    EXPECT_EQ(between(alone, 15, 35)->source, MotionSource::Prediction);
    const Pose2 over_nothing = compose(inverse(scene.poses[15]), scene.poses[35]);
    const auto told = between(with_wheels, 15, 35);
    ASSERT_TRUE(told);
    EXPECT_NE(told->source, MotionSource::Prediction);
    EXPECT_NEAR(told->T_from_to.x_m, over_nothing.x_m, 0.01);
    EXPECT_NEAR(told->T_from_to.yaw_rad, over_nothing.yaw_rad, 0.01);
}

/// A turn of 0.10 rad by the flow, averaged with a turn that is told as a prior.
EgoMotion averaged_turn(double told_rad, bool outdoes_flow) {
    EgoMotion flow;
    flow.omega_rad = 0.10;
    flow.sigma_omega_rad = 0.01;
    flow.omega_measured = true;
    flow.omega_source = MotionSource::Flow;
    pipeline::ToldMotion told;
    told.turn =
        pipeline::ToldValue{told_rad, 0.01, MotionSource::Gyro, pipeline::SensorUse::Prior, outdoes_flow};
    return pipeline::averaged(flow, told);
}

TEST(AveragedTurn, IsTheMeanOfValuesThatAreEquallyGood) {
    const EgoMotion motion = averaged_turn(0.12, false);
    EXPECT_NEAR(motion.omega_rad, 0.11, 1e-12);
    EXPECT_NEAR(motion.sigma_omega_rad, 0.01 / std::sqrt(2.0), 1e-12);
}

TEST(AveragedTurn, IsThatOfTheFlowWhereTheOtherDiffersMuch) {
    const EgoMotion motion = averaged_turn(0.20, false);
    EXPECT_EQ(motion.omega_rad, 0.10);
    EXPECT_EQ(motion.omega_source, MotionSource::Flow);
}

TEST(AveragedTurn, IsThatOfAGyroThatAgreedBeforeWhereTheFlowDiffersMuch) {
    const EgoMotion motion = averaged_turn(0.20, true);
    EXPECT_NEAR(motion.omega_rad, 0.20, 1e-12);
    EXPECT_EQ(motion.sigma_omega_rad, 0.01);
    EXPECT_EQ(motion.omega_source, MotionSource::Gyro);
}

EgoMotion measured(double forward_m, double sigma_forward_m, double sigma_omega_rad) {
    EgoMotion motion;
    motion.forward_m = forward_m;
    motion.sigma_forward_m = sigma_forward_m;
    motion.sigma_omega_rad = sigma_omega_rad;
    motion.omega_measured = motion.forward_measured = true;
    return motion;
}

/// Covariance after `cycles` straight cycles of 0.1 m that begin with the heading `yaw_rad`.
Eigen::Matrix3d after_straight(int cycles, double yaw_rad) {
    PoseUncertainty uncertainty;
    Pose2 T_start_reference{0.0, 0.0, yaw_rad};
    for (int i = 0; i < cycles; ++i) {
        const EgoMotion motion = measured(0.1, 0.002, 0.001);
        uncertainty.move(T_start_reference, motion);
        T_start_reference = compose(T_start_reference, pose_after(motion));
        uncertainty.begin_cycle();
    }
    return uncertainty.covariance(T_start_reference, {});
}

TEST(PoseUncertainty, OfAStraightWayGrowsAlongByTravelAndAcrossByHeading) {
    const Eigen::Matrix3d covariance = after_straight(100, 0.0);
    EXPECT_NEAR(std::sqrt(covariance(0, 0)), std::hypot(0.02, 0.1), 1e-6);  // cycles, and 1 % of 10 m
    EXPECT_NEAR(std::sqrt(covariance(2, 2)), 0.01, 1e-9);
    EXPECT_NEAR(std::sqrt(covariance(1, 1)), 0.01 * 10.0 / std::sqrt(3.0), 1e-3);
    EXPECT_GT(covariance(1, 2), 0.0) << "a heading too far left leads too far left";
}

TEST(PoseUncertainty, TurnsWithTheWay) {
    const Eigen::Matrix3d ahead = after_straight(100, 0.0);
    const Eigen::Matrix3d left = after_straight(100, M_PI / 2);
    EXPECT_NEAR(left(1, 1), ahead(0, 0), 1e-9);
    EXPECT_NEAR(left(0, 0), ahead(1, 1), 1e-9);
    EXPECT_LT(left(0, 2), 0.0);
    EXPECT_GE(left.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
}

TEST(PoseUncertainty, HasWhatWasCarriedOver) {
    const Eigen::Matrix3d covariance = PoseUncertainty().covariance({}, {1.0, 0.3, 0.2});
    EXPECT_NEAR(covariance(0, 0), 0.09, 1e-12);
    EXPECT_NEAR(covariance(1, 1), 0.09, 1e-12);
    EXPECT_NEAR(covariance(2, 2), 0.04, 1e-12);
}

}  // namespace
}  // namespace flownav
