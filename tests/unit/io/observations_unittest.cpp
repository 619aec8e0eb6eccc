#include "flownav/io/observations.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>
#include <mrpt/maps/COccupancyGridMap2D.h>

namespace flownav::io {
namespace {

/// Three beams: straight ahead free, to its left an obstacle, to its right unknown.
pipeline::Step finished_cycle() {
    pipeline::Step step;
    step.timestamp_s = 1767225600.25;
    step.status = FieldStatus::Ok;
    step.end_of_cycle = true;
    step.omega_radps = 0.3;
    step.v_mps = 0.4;
    step.T_start_robot = {1.0, -2.0, 0.5};
    step.obstacles = {{{2.0, 0.5, 0.3}, 0.05, {104.0, 62.0}}};
    step.scan = {-0.2, 0.2, {{BeamKind::Unknown, 0.0}, {BeamKind::Free, 1.5}, {BeamKind::Obstacle, 2.0}}};
    return step;
}

TEST(Observations, OnlyABeamThatEndsAtAnObstacleIsValid) {
    const auto scan = scan_observation(finished_cycle(), 8.0);
    EXPECT_EQ(scan->sensorLabel, "FLOW_SCAN");
    EXPECT_NEAR(mrpt::Clock::toDouble(scan->timestamp), 1767225600.25, 1e-6);
    ASSERT_EQ(scan->getScanSize(), 3U);
    EXPECT_FALSE(scan->getScanRangeValidity(0));
    EXPECT_EQ(scan->getScanRange(0), 0.0F);
    EXPECT_FALSE(scan->getScanRangeValidity(1)) << "a bearing that is free has no obstacle at its end";
    EXPECT_EQ(scan->getScanRange(1), 1.5F) << "as far as its floor was confirmed";
    EXPECT_TRUE(scan->getScanRangeValidity(2));
    EXPECT_EQ(scan->getScanRange(2), 2.0F);
}

TEST(Observations, AnObstacleIsARangeWhateverItsCauseAndUnknownStaysInvalid) {
    for (const BeamCause cause : {BeamCause::Blocks, BeamCause::Votes, BeamCause::Wall, BeamCause::Drop}) {
        pipeline::Step step = finished_cycle();
        step.scan.beams[1] = {BeamKind::Obstacle, 1.25, cause, 1.1, 1.4};
        const auto scan = scan_observation(step, 8.0);
        EXPECT_TRUE(scan->getScanRangeValidity(1)) << to_string(cause);
        EXPECT_EQ(scan->getScanRange(1), 1.25F) << to_string(cause);
        EXPECT_FALSE(scan->getScanRangeValidity(0));
    }
}

TEST(Observations, TheBeamToTheLeftIsALeftPointOfTheMap) {
    const auto scan = scan_observation(finished_cycle(), 8.0);
    mrpt::maps::CSimplePointsMap points;
    points.insertObservation(*scan);
    ASSERT_EQ(points.size(), 1U);
    float x = 0;
    float y = 0;
    points.getPoint(0, x, y);
    EXPECT_NEAR(x, 2.0 * std::cos(0.2), 1e-4);
    EXPECT_NEAR(y, 2.0 * std::sin(0.2), 1e-4);
}

TEST(Observations, AScanThatIsNotCentredKeepsItsBearings) {
    pipeline::Step step = finished_cycle();
    step.scan.first_bearing_rad = 0.4;
    mrpt::maps::CSimplePointsMap points;
    points.insertObservation(*scan_observation(step, 8.0));
    ASSERT_EQ(points.size(), 1U);
    float x = 0;
    float y = 0;
    points.getPoint(0, x, y);
    EXPECT_NEAR(std::atan2(y, x), 0.8, 1e-4);
}

TEST(Observations, BlindBeamsStayUnknownInAnOccupancyGrid) {
    pipeline::Step step = finished_cycle();
    step.scan.beams[2] = {};
    mrpt::maps::COccupancyGridMap2D grid(-10, 10, -10, 10, 0.1F);
    grid.insertionOptions.considerInvalidRangesAsFreeSpace = false;
    grid.insertObservation(*scan_observation(step, 8.0));
    EXPECT_NEAR(grid.getPos(1.0F, 0.0F), 0.5, 0.01);
    EXPECT_NEAR(grid.getPos(3.0F, 0.0F), 0.5, 0.01);
}

TEST(Observations, PointsAreThoseOfTheRobotFrame) {
    const auto cloud = points_observation(finished_cycle());
    EXPECT_EQ(cloud->sensorLabel, "FLOW_POINTS");
    ASSERT_EQ(cloud->pointcloud->size(), 1U);
    float x = 0;
    float y = 0;
    float z = 0;
    cloud->pointcloud->getPoint(0, x, y, z);
    EXPECT_FLOAT_EQ(x, 2.0F);
    EXPECT_FLOAT_EQ(y, 0.5F);
    EXPECT_FLOAT_EQ(z, 0.3F);
}

TEST(Observations, ACycleWithoutObstaclesIsAnEmptyCloud) {
    const auto cloud = points_observation(pipeline::Step{});
    ASSERT_TRUE(cloud->pointcloud);
    EXPECT_TRUE(cloud->pointcloud->empty());
}

TEST(Observations, OdometryHasPoseAndMeasuredRates) {
    const auto odometry = odometry_observation(finished_cycle());
    EXPECT_EQ(odometry->sensorLabel, "FLOW_ODOMETRY");
    EXPECT_DOUBLE_EQ(odometry->odometry.x(), 1.0);
    EXPECT_DOUBLE_EQ(odometry->odometry.y(), -2.0);
    EXPECT_DOUBLE_EQ(odometry->odometry.phi(), 0.5);
    ASSERT_TRUE(odometry->hasVelocities);
    EXPECT_DOUBLE_EQ(odometry->velocityLocal.vx, 0.4);
    EXPECT_DOUBLE_EQ(odometry->velocityLocal.omega, 0.3);
}

TEST(Observations, ThePoseHasItsCovariance) {
    pipeline::Step step = finished_cycle();
    step.covariance << 0.04, 0.01, 0.002, 0.01, 0.09, 0.003, 0.002, 0.003, 0.0025;
    const auto observation = pose_observation(step);
    EXPECT_EQ(observation->sensorLabel, "FLOW_POSE");
    EXPECT_DOUBLE_EQ(observation->pose.mean.x(), 1.0);
    EXPECT_DOUBLE_EQ(observation->pose.mean.yaw(), 0.5);
    const auto& covariance = observation->pose.cov;  // x, y, z, yaw, pitch, roll
    EXPECT_DOUBLE_EQ(covariance(0, 0), 0.04);
    EXPECT_DOUBLE_EQ(covariance(1, 1), 0.09);
    EXPECT_DOUBLE_EQ(covariance(3, 3), 0.0025);
    EXPECT_DOUBLE_EQ(covariance(0, 1), 0.01);
    EXPECT_DOUBLE_EQ(covariance(3, 0), 0.002);
    EXPECT_DOUBLE_EQ(covariance(2, 2), 0.0);
}

TEST(Observations, OdometryOfALostFieldHasNoRates) {
    pipeline::Step step = finished_cycle();
    step.status = FieldStatus::Lost;
    EXPECT_FALSE(odometry_observation(step)->hasVelocities);
}

}  // namespace
}  // namespace flownav::io
