#include "flownav/replay/result_rawlog.h"

#include <gtest/gtest.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/obs/CObservationImage.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>

#include <map>

#include "flownav/io/field_source.h"
#include "rawlog_files.h"
#include "step_samples.h"

namespace flownav::replay {
namespace {

using testing::content;
using testing::pal_field;
using testing::step_at;
using testing::test_folder;

void write_sample(const std::filesystem::path& file, bool images) {
    ResultRawlog rawlog(file, 8.0);
    for (int i = 0; i < 9; ++i) {
        rawlog.write_odometry(
            {io::PoseSample::Source::Odometry, step_at(i).timestamp_s, {0.016 * i, 0.1, 0, 0.2, 0, 0}});
        if (images) rawlog.write_image(pal_field(i), "CAMERA1");
        rawlog.write(step_at(i));
    }
    rawlog.close();
}

TEST(ResultRawlog, HoldsOnlyStandardClassesInTheGivenOrder) {
    const auto file = test_folder() / "result.rawlog";
    write_sample(file, true);
    io::RawlogReader reader(file);
    std::map<std::string, int> classes;
    while (const auto observation = reader.next()) {
        ++classes[std::string(observation->GetRuntimeClass()->className) + ' ' + observation->sensorLabel];
    }
    EXPECT_EQ(reader.end().kind, io::ReadEnd::Kind::Clean) << reader.end().message;
    const std::map<std::string, int> expected = {{"mrpt::obs::CObservationOdometry ODOMETRY", 9},
                                                 {"mrpt::obs::CObservationOdometry FLOW_ODOMETRY", 9},
                                                 {"mrpt::obs::CObservationRobotPose FLOW_POSE", 9},
                                                 {"mrpt::obs::CObservation2DRangeScan FLOW_SCAN", 2},
                                                 {"mrpt::obs::CObservationPointCloud FLOW_POINTS", 2},
                                                 {"mrpt::obs::CObservationImage CAMERA1", 9}};
    EXPECT_EQ(classes, expected);
}

TEST(ResultRawlog, KeptImagesReplayWithTheCalibrationThatWasUsed) {
    const auto file = test_folder() / "result.rawlog";
    write_sample(file, true);
    io::RawlogReader reader(file);
    io::FieldSource source(reader, {});
    int fields = 0;
    while (const auto event = source.next()) {
        const auto* field = std::get_if<Field>(&*event);
        if (field == nullptr) continue;
        const Field original = pal_field(fields++);
        EXPECT_TRUE(same_geometry(field->camera, original.camera));
        EXPECT_NEAR(field->camera.cy_px, original.camera.cy_px, 1e-9);
        EXPECT_NEAR(field->camera.mount.pitch_rad, original.camera.mount.pitch_rad, 1e-9);
        EXPECT_NEAR(field->camera.mount.roll_rad, original.camera.mount.roll_rad, 1e-9);
        EXPECT_NEAR(field->camera.mount.yaw_rad, original.camera.mount.yaw_rad, 1e-9);
        EXPECT_NEAR(field->timestamp_s, original.timestamp_s, 1e-6);
        EXPECT_EQ(field->image.at(700, 200), original.image.at(700, 200));
    }
    EXPECT_EQ(fields, 9);
}

TEST(ResultRawlog, TheSameStepsGiveTheSameBytes) {
    const auto folder = test_folder();
    write_sample(folder / "a", true);
    write_sample(folder / "b", true);
    EXPECT_EQ(content(folder / "a"), content(folder / "b"));
}

TEST(ResultRawlog, CountsWhatItWroteByLabel) {
    ResultRawlog rawlog(test_folder() / "result.rawlog", 8.0);
    rawlog.write(step_at(3));
    rawlog.write(step_at(4));
    const std::map<std::string, std::uint64_t> expected = {
        {"FLOW_ODOMETRY", 2}, {"FLOW_POINTS", 1}, {"FLOW_POSE", 2}, {"FLOW_SCAN", 1}};
    EXPECT_EQ(rawlog.counts(), expected);
}

}  // namespace
}  // namespace flownav::replay
