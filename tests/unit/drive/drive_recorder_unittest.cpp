#include "flownav/drive/drive_recorder.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservationRobotPose.h>

#include "flownav/io/field_source.h"
#include "flownav/io/output_file.h"
#include "temporary_folder.h"

namespace flownav::drive {
namespace {

using testing::bytes_of;
using testing::TemporaryFolder;

Field field_at(double timestamp_s) {
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>(64 * 48, 100);
    Field field;
    field.timestamp_s = timestamp_s;
    field.image = {pixels->data(), 64, 48, 64};
    field.camera.width_px = 64;
    field.camera.height_px = 48;
    field.camera.fx_px = field.camera.fy_px = 60.0;
    field.camera.mount.pitch_rad = 0.3;
    field.owner = pixels;
    return field;
}

TEST(DriveRecorder, WritesFieldsAndPosesThatCanBeReadAgain) {
    const TemporaryFolder folder;
    DriveRecorder recorder({folder / "run.rawlog", {}, true});
    for (int i = 0; i < 5; ++i) {
        recorder.on_field(field_at(1000.0 + i), {});
        recorder.on_odometry(1000.5 + i, {0.1 * i, 0.0, 0.0});
        recorder.on_truth(1000.5 + i, {0.1 * i, 0.0, 0.0}, Eigen::Isometry3d::Identity());
    }
    recorder.complete();
    EXPECT_EQ(recorder.fields_left_out(), 0);
    io::RawlogReader reader(folder / "run.rawlog");
    io::FieldSource source(reader, {});
    while (source.next()) {
        // Reads all events.
    }
    EXPECT_EQ(source.counts().fields, 5U);
    EXPECT_EQ(source.counts().odometry, 5U);
    EXPECT_EQ(source.counts().ground_truth, 5U);
}

TEST(DriveRecorder, TheTruthOnARampHasHeightAndPitch) {
    const TemporaryFolder folder;
    DriveRecorder recorder({folder / "run.rawlog", {}, true});
    Eigen::Isometry3d T_flat_robot = Eigen::Isometry3d::Identity();
    T_flat_robot.translation().z() = 0.3;
    T_flat_robot.rotate(Eigen::AngleAxisd(-0.1, Eigen::Vector3d::UnitY()));  // nose up
    recorder.on_truth(1000.0, {1.0, 2.0, 0.5}, T_flat_robot);
    recorder.complete();
    io::RawlogReader reader(folder / "run.rawlog");
    const auto truth = std::dynamic_pointer_cast<mrpt::obs::CObservationRobotPose>(reader.next());
    ASSERT_TRUE(truth);
    EXPECT_NEAR(truth->pose.mean.z(), 0.3, 1e-9);
    EXPECT_NEAR(truth->pose.mean.yaw(), 0.5, 1e-9);
    EXPECT_NEAR(truth->pose.mean.pitch(), -0.1, 1e-9);
    EXPECT_NEAR(truth->pose.mean.roll(), 0.0, 1e-9);
}

TEST(DriveRecorder, AFullDiskIsToldWhenTheDriveIsOver) {
    DriveRecorder recorder({"/dev/full", {}, true});
    for (int i = 0; i < 100; ++i) recorder.on_field(field_at(1000.0 + i), {});
    EXPECT_THROW(recorder.complete(), io::OutputError);
}

TEST(DriveRecorder, ARowWithoutTruthLeavesItsCellsEmpty) {
    DriveSample sample;
    sample.time_s = 1.5;
    sample.T_map_robot = {2.0, -1.0, 0.5};
    const auto cells = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
    const std::string row = drive_csv_row(sample, {}, nav::GuardAction::Pass);
    EXPECT_EQ(row.rfind("1.50,,,,,,2.0000,-1.0000,0.50000,", 0), 0U) << row;
    EXPECT_EQ(cells(row), cells(drive_csv_header()));
    sample.truth_known = true;
    sample.T_world_robot = {3.0, 4.0, 0.0};
    EXPECT_EQ(drive_csv_row(sample, {}, nav::GuardAction::Pass).rfind("1.50,3.0000,4.0000,", 0), 0U);
}

}  // namespace
}  // namespace flownav::drive
