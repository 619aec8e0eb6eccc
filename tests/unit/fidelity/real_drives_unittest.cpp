#include <gtest/gtest.h>

#include "real_data.h"

/// Runs the chain on public recordings; skipped when they are missing.
namespace flownav::fidelity {
namespace {

class RealDrives : public ::testing::Test {
  protected:
    void need(const std::filesystem::path& folder) {
        if (!std::filesystem::exists(folder))
            GTEST_SKIP() << "no " << folder << "; set FLOWNAV_DATA to the folder with the recordings";
    }
    const std::filesystem::path data = data_folder();
};

TEST_F(RealDrives, KittiOdometryLocksFromAColdStartAndEndsWhereItShould) {
    need(data / "kitti-odometry");
    if (IsSkipped()) return;
    const OdometryScore score = odometry_score(data / "kitti-odometry");
    EXPECT_GE(score.first_ok, 1);
    EXPECT_LE(score.first_ok, 3);
    EXPECT_GT(score.ok.percent(), 85.0);
    EXPECT_LT(score.errors.omega_rms_degps.value(), 0.35);
    EXPECT_LT(score.errors.end_position_percent.value(), 4.0);
    EXPECT_LT(std::abs(score.errors.heading_end_deg.value()), 1.0);
}

TEST_F(RealDrives, LidarConfirmsTheObstaclesOfABrakingCar) {
    need(data / "kitti-raw");
    if (IsSkipped()) return;
    const LidarScore score = braking_score(data / "kitti-raw" / "2011_09_26", {});
    EXPECT_GT(score.points_near.all, 1000);
    EXPECT_GT(score.points_near.percent(), 92.0);
    EXPECT_GT(score.points_near.percent(), score.control_near.percent() + 20.0);
    EXPECT_GT(score.cells_found.percent(), 40.0);
    EXPECT_GT(score.things_lately.percent(), 60.0);
}

TEST_F(RealDrives, TheTurnOfASmallCarFollowsItsGyro) {
    need(data / "donkeycar-gyro");
    if (IsSkipped()) return;
    const GyroScore score = gyro_score(data / "donkeycar-gyro", pipeline::SensorUse::Off);
    EXPECT_GT(score.ok.percent(), 80.0);
    EXPECT_GT(score.correlation, 0.9);
    EXPECT_LT(score.median_difference_degps, 4.0);
}

TEST_F(RealDrives, WithItsGyroTheTurnOfASmallCarIsKnownInAllImages) {
    need(data / "donkeycar-gyro");
    if (IsSkipped()) return;
    const GyroScore score = gyro_score(data / "donkeycar-gyro", pipeline::SensorUse::Prior);
    EXPECT_GT(score.known.percent(), 99.0);
    EXPECT_LT(score.difference_degps.rms(), 4.4);  // below half of that of the camera alone
}

TEST_F(RealDrives, WhatIsMissingIsSaid) {
    const std::string report = real_data_report({"no_such_folder", {}, {}});
    std::size_t said = 0;
    for (auto at = report.find("Not measured"); at != std::string::npos;
         at = report.find("Not measured", at + 1))
        ++said;
    EXPECT_EQ(said, 3U);
}

}  // namespace
}  // namespace flownav::fidelity
