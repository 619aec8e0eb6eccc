#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "flownav/io/field_source.h"
#include "flownav/io/image_folder.h"
#include "flownav/io/kitti.h"
#include "flownav/io/output_file.h"
#include "flownav/io/recording_writer.h"
#include "flownav/io/video_file.h"
#include "flownav/math/units.h"
#include "import_samples.h"
#include "rawlog_files.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;
using namespace flownav::testing;

CameraMount car_camera() {
    CameraMount mount;
    mount.height_m = 1.65;
    mount.pitch_rad = 2 * degree_rad;
    mount.forward_m = 1.1;
    return mount;
}

struct Recorded {
    std::vector<Field> fields;
    std::vector<PoseSample> poses;
};

Recorded read_back(const fs::path& file) {
    RawlogReader reader(file);
    FieldSource source(reader, {});
    Recorded result;
    while (const auto event = source.next()) {
        if (const auto* field = std::get_if<Field>(&*event)) {
            result.fields.push_back(*field);
        } else {
            result.poses.push_back(std::get<PoseSample>(*event));
        }
    }
    EXPECT_EQ(reader.end().kind, ReadEnd::Kind::Clean) << reader.end().message;
    EXPECT_TRUE(source.counts().rejected.empty());
    EXPECT_TRUE(source.counts().warnings.empty());
    return result;
}

Recorded import(ImageSequence& sequence, config::Interlaced interlaced = config::Interlaced::None) {
    RecordingOptions options;
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    options.output = fs::path(::testing::TempDir()) / "flownav_replay_input" / test->test_suite_name() /
                     (std::string(test->name()) + ".rawlog");
    options.interlaced = interlaced;
    write_recording(sequence, options);
    return read_back(options.output);
}

template <class Sequence, class... Arguments>
std::string input_error(const Arguments&... arguments) {
    try {
        Sequence sequence(arguments...);
        while (sequence.next()) continue;
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

void expect_names(const std::string& message, std::initializer_list<const char*> parts) {
    for (const char* part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
}

void write_kitti_odometry(const fs::path& folder) {
    const fs::path sequence = folder / "sequences" / "00";
    for (int i = 0; i < 3; ++i)
        write_sample_picture(sequence / "image_0" / ("00000" + std::to_string(i) + ".png"), i);
    write_bytes(sequence / "calib.txt",
                "P0: 60 0 31.5 0 0 61 23.5 0 0 0 1 0\nP1: 60 0 31.5 -30 0 61 23.5 0 0 0 1 0\n");
    write_bytes(sequence / "times.txt", "0.000000e+00\n1.037359e-01\n2.073381e-01\n");
}

/// Writes the poses of a camera 1.1 m ahead of the axis of a car that turns left by 90 degrees about the
/// axis, then drives 2 m.
void write_turning_poses(const fs::path& folder) {
    fs::create_directories(folder / "poses");
    write_bytes(folder / "poses" / "00.txt",
                "1 0 0 0 0 1 0 0 0 0 1 0\n"
                "0 0 -1 -1.1 0 1 0 0 1 0 0 -1.1\n"
                "0 0 -1 -3.1 0 1 0 0 1 0 0 -1.1\n");
}

TEST(KittiOdometry, ImagesTimesAndCalibrationComeThrough) {
    const auto folder = test_folder();
    write_kitti_odometry(folder);
    KittiOdometry sequence(folder, "00", car_camera());
    const auto recorded = import(sequence);
    ASSERT_EQ(recorded.fields.size(), 3U);
    EXPECT_TRUE(recorded.poses.empty());
    EXPECT_EQ(recorded.fields[2].image.at(10, 20), 62);
    EXPECT_NEAR(recorded.fields[0].timestamp_s, 0.0, 1e-6);
    EXPECT_NEAR(recorded.fields[1].timestamp_s, 0.1037359, 1e-6);
    const CameraModel& camera = recorded.fields[1].camera;
    EXPECT_DOUBLE_EQ(camera.fx_px, 60);
    EXPECT_DOUBLE_EQ(camera.fy_px, 61);
    EXPECT_DOUBLE_EQ(camera.cx_px, 31.5);
    EXPECT_NEAR(camera.mount.height_m, 1.65, 1e-9);
    EXPECT_NEAR(camera.mount.pitch_rad, 2 * degree_rad, 1e-9);
    EXPECT_NEAR(camera.mount.forward_m, 1.1, 1e-9);
    EXPECT_NEAR(camera.mount.left_m, 0, 1e-9);
}

TEST(KittiOdometry, CameraPosesBecomePosesOfTheAxis) {
    const auto folder = test_folder();
    write_kitti_odometry(folder);
    write_turning_poses(folder);
    CameraMount mount = car_camera();
    mount.pitch_rad = 0;
    KittiOdometry sequence(folder, "00", mount);
    const auto poses = import(sequence).poses;
    ASSERT_EQ(poses.size(), 3U);
    EXPECT_EQ(poses[0].source, PoseSample::Source::GroundTruth);
    const double expected[3][3] = {{0, 0, 0}, {0, 0, M_PI / 2}, {0, 2, M_PI / 2}};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(poses[i].pose.x, expected[i][0], 1e-9) << i;
        EXPECT_NEAR(poses[i].pose.y, expected[i][1], 1e-9) << i;
        EXPECT_NEAR(poses[i].pose.yaw, expected[i][2], 1e-9) << i;
        EXPECT_NEAR(poses[i].pose.z, 0, 1e-12);
    }
}

TEST(KittiOdometry, DamagedImageIsLeftOutAndReported) {
    const auto folder = test_folder();
    write_kitti_odometry(folder);
    write_bytes(folder / "sequences" / "00" / "image_0" / "000001.png", "no picture");
    KittiOdometry sequence(folder, "00", car_camera());
    EXPECT_EQ(import(sequence).fields.size(), 2U);
    ASSERT_EQ(sequence.problems().size(), 1U);
    expect_names(sequence.problems()[0], {"000001.png", "cannot be read"});
}

TEST(KittiOdometry, MissingPartsAreNamed) {
    const auto folder = test_folder();
    expect_names(input_error<KittiOdometry>(folder / "gone", "00", car_camera()), {"gone", "no such folder"});
    expect_names(input_error<KittiOdometry>(folder, "07", car_camera()), {"07", "no such folder"});
    write_kitti_odometry(folder);
    write_bytes(folder / "sequences" / "00" / "calib.txt", "P1: 1 2 3\n");
    expect_names(input_error<KittiOdometry>(folder, "00", car_camera()), {"calib.txt", "P0"});
    write_kitti_odometry(folder);
    fs::create_directories(folder / "poses");
    write_bytes(folder / "poses" / "00.txt", "1 2 3\n");
    expect_names(input_error<KittiOdometry>(folder, "00", car_camera()), {"00.txt, line 1", "no pose"});
}

void write_kitti_raw(const fs::path& folder) {
    const fs::path drive = folder / "2011_09_26_drive_0005_sync";
    for (int i = 0; i < 3; ++i) {
        write_sample_picture(drive / "image_02" / "data" / ("000000000" + std::to_string(i) + ".png"), i);
    }
    write_bytes(folder / "calib_cam_to_cam.txt",
                "calib_time: 09-Jan-2012 13:57:47\nP_rect_02: 60 0 31.5 3.6 0 60 23.5 0 0 0 1 0\n");
}

TEST(KittiRaw, DriveIsFoundByItsNumberAndTimedByTheRate) {
    const auto folder = test_folder();
    write_kitti_raw(folder);
    KittiRaw sequence(folder, "0005", 10, car_camera());
    const auto recorded = import(sequence);
    ASSERT_EQ(recorded.fields.size(), 3U);
    EXPECT_NEAR(recorded.fields[2].timestamp_s, 0.2, 1e-6);
    EXPECT_NEAR(recorded.fields[0].camera.mount.left_m, 0.06, 1e-9);
    EXPECT_TRUE(recorded.poses.empty());
}

TEST(KittiRaw, TimesAndPosesAreTakenWhenTheyAreThere) {
    const auto folder = test_folder();
    write_kitti_raw(folder);
    const fs::path drive = folder / "2011_09_26_drive_0005_sync";
    write_bytes(drive / "image_02" / "timestamps.txt",
                "2011-09-26 13:02:44.326092134\n2011-09-26 13:02:44.429828531\n2011-09-26 13:02:44.533\n");
    fs::create_directories(drive / "oxts" / "data");
    // The drive heads north; 1e-5 degrees of latitude are 1.113 m.
    for (int i = 0; i < 3; ++i) {
        write_bytes(drive / "oxts" / "data" / ("000000000" + std::to_string(i) + ".txt"),
                    std::to_string(49.0 + 0.00001 * i) + " 8.4 116 0 0 1.5707963267949 5 5 5\n");
    }
    KittiRaw sequence(folder, "2011_09_26_drive_0005_sync", 10, car_camera());
    const auto recorded = import(sequence);
    ASSERT_EQ(recorded.poses.size(), 3U);
    EXPECT_NEAR(recorded.fields[0].timestamp_s, 1317042164.326092, 1e-6);
    EXPECT_NEAR(recorded.poses[2].pose.x, 2 * 1.113, 0.01);
    EXPECT_NEAR(recorded.poses[2].pose.y, 0, 0.01);
    EXPECT_NEAR(recorded.poses[2].pose.yaw, 0, 1e-9);
}

TEST(KittiRaw, UnknownDriveIsNamed) {
    const auto folder = test_folder();
    write_kitti_raw(folder);
    expect_names(input_error<KittiRaw>(folder, "0099", 10.0, car_camera()), {"0099"});
}

TEST(ImageFolder, NumbersInNamesOrderAsNumbers) {
    const auto folder = test_folder();
    for (const int i : {1, 2, 10, 9}) write_sample_picture(folder / ("img" + std::to_string(i) + ".png"), i);
    ImageFolder sequence(folder, sample_camera(), {{}, 20.0});
    const auto fields = import(sequence).fields;
    ASSERT_EQ(fields.size(), 4U);
    const int order[] = {1, 2, 9, 10};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(fields[i].image.at(0, 0), order[i]);
        EXPECT_NEAR(fields[i].timestamp_s, (order[i] - 1) / 20.0, 1e-6);
    }
}

TEST(ImageFolder, ColourBecomesGrey) {
    const auto folder = test_folder();
    cv::imwrite((folder / "a.png").string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar(10, 200, 90)));
    ImageFolder sequence(folder, sample_camera(), {});
    EXPECT_NEAR(import(sequence).fields.at(0).image.at(5, 5), 0.114 * 10 + 0.587 * 200 + 0.299 * 90, 1);
}

TEST(ImageFolder, TimesBesideTheFolderAreTaken) {
    const auto folder = test_folder();
    for (int i = 0; i < 2; ++i) write_sample_picture(folder / "images" / (std::to_string(i) + ".png"), i);
    write_bytes(folder / "log.csv", "index,timestamp_s,gyro\n0,1709732520.775,7\n1,1709732520.824,8\n");
    for (const auto& directory : {folder / "images", folder / "images" / ""}) {
        ImageFolder sequence(directory, sample_camera(), {});
        sequence.next();
        EXPECT_NEAR(sequence.next()->field.timestamp_s, 1709732520.824, 1e-6);
        expect_names(sequence.times_source(), {"log.csv"});
    }
    ImageFolder constant(folder / "images", sample_camera(), {{}, 10.0});
    constant.next();
    EXPECT_NEAR(constant.next()->field.timestamp_s, 0.1, 1e-9);
}

TEST(ImageFolder, TimesFileWithoutHeaderUsesTheFirstColumn) {
    const auto folder = test_folder();
    for (int i = 0; i < 2; ++i) write_sample_picture(folder / (std::to_string(i) + ".png"), i);
    write_bytes(folder / "times.txt", "0.5 7\n0.75 8\n");
    ImageFolder sequence(folder, sample_camera(), {});
    EXPECT_NEAR(sequence.next()->field.timestamp_s, 0.5, 1e-12);
    EXPECT_NEAR(sequence.next()->field.timestamp_s, 0.75, 1e-12);
}

TEST(ImageFolder, AColumnOfTurnRatesBecomesReadingsOfAGyroHalfWayBetweenTheRows) {
    const auto folder = test_folder();
    for (int i = 0; i < 3; ++i) write_sample_picture(folder / "images" / (std::to_string(i) + ".png"), i);
    write_bytes(folder / "log.csv", "timestamp_s,gyro_z_degps\n5.0,90\n5.1,-45\n5.3,0\n");
    ImageFolder sequence(folder / "images", sample_camera(), {});
    const auto gyro = sequence.gyro();
    ASSERT_EQ(gyro.size(), 2U);
    EXPECT_NEAR(gyro[0].timestamp_s, 5.05, 1e-9);
    EXPECT_NEAR(gyro[0].omega_radps, 90 * degree_rad, 1e-9);
    EXPECT_NEAR(gyro[1].timestamp_s, 5.2, 1e-9);
    EXPECT_NEAR(gyro[1].omega_radps, -45 * degree_rad, 1e-9);
    const fs::path output = folder / "with_gyro.rawlog";
    RecordingOptions options;
    options.output = output;
    EXPECT_EQ(write_recording(sequence, options).gyro, 2U);
    RawlogReader reader(output);
    FieldSource source(reader, {});
    while (source.next()) continue;
    EXPECT_EQ(source.counts().gyro, 2U);
    EXPECT_EQ(source.counts().fields, 3U);
    write_bytes(folder / "log.csv", "timestamp_s,gyro_z_radps\n5.0,0.5\n5.1,0.25\n5.3,0\n");
    EXPECT_NEAR(ImageFolder(folder / "images", sample_camera(), {}).gyro().at(0).omega_radps, 0.5, 1e-12);
    EXPECT_TRUE(ImageFolder(folder / "images", sample_camera(), {{}, 10.0}).gyro().empty());
}

TEST(ImageFolder, UnusableTimesAreNamed) {
    const auto folder = test_folder();
    for (int i = 0; i < 3; ++i) write_sample_picture(folder / (std::to_string(i) + ".png"), i);
    const auto error_with = [&](const std::string& text) {
        write_bytes(folder / "t.csv", text);
        return input_error<ImageFolder>(folder, sample_camera(), FrameTimes{folder / "t.csv", std::nullopt});
    };
    expect_names(error_with("0\n0.5\n"), {"t.csv", "2 times for 3 images"});
    expect_names(error_with("0\n0.5\n0.5\n"), {"t.csv, line 3", "not later"});
    expect_names(error_with("index,when\n0,1\n"), {"t.csv", "timestamp_s"});
    expect_names(error_with("0\nnever\n2\n"), {"t.csv, line 2"});
    expect_names(error_with(""), {"t.csv", "empty"});
}

TEST(ImageFolder, FolderWithoutImagesIsNamed) {
    expect_names(input_error<ImageFolder>(test_folder(), sample_camera(), FrameTimes{}), {"holds no images"});
}

TEST(ImageFolder, MissingCalibrationNamesTheKeysAndLeavesNothing) {
    const auto folder = test_folder();
    write_sample_picture(folder / "a.png", 1);
    ImageFolder sequence(folder, config::CameraConfig{}, {});
    RecordingOptions options;
    options.output = folder / "out.rawlog";
    try {
        write_recording(sequence, options);
        FAIL() << "no calibration was given";
    } catch (const config::ConfigError& e) {
        expect_names(e.what(), {"camera.fx_px", "camera.height_m", "camera.pitch_deg"});
    }
    EXPECT_FALSE(fs::exists(folder / "out.rawlog"));
    EXPECT_FALSE(fs::exists(folder / "out.rawlog.part"));
}

TEST(WriteRecording, WovenFramesAreWrittenAsFields) {
    const auto folder = test_folder();
    for (int i = 0; i < 3; ++i) write_sample_picture(folder / (std::to_string(i) + ".png"), i);
    ImageFolder sequence(folder, sample_camera(), {{}, 25.0});
    const auto fields = import(sequence, config::Interlaced::BottomFirst).fields;
    ASSERT_EQ(fields.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(fields[i].timestamp_s, 0.02 * static_cast<double>(i), 1e-6);
    EXPECT_EQ(fields[2].image.at(3, 4), 3 * 9 + 1);
    EXPECT_EQ(fields[3].image.at(3, 4), 3 * 8 + 1);
    EXPECT_EQ(fields[2].image.height_px, 24);
    EXPECT_DOUBLE_EQ(fields[2].camera.fy_px, 30);
    EXPECT_DOUBLE_EQ(fields[2].camera.cy_px, 11.25);
    EXPECT_DOUBLE_EQ(fields[3].camera.cy_px, 11.75);
}

TEST(WriteRecording, SameInputGivesTheSameBytes) {
    const auto folder = test_folder();
    for (int i = 0; i < 3; ++i) write_sample_picture(folder / "images" / (std::to_string(i) + ".png"), i);
    std::string bytes[2];
    for (auto& copy : bytes) {
        ImageFolder sequence(folder / "images", sample_camera(), {});
        RecordingOptions options;
        options.output = folder / "out.rawlog";
        write_recording(sequence, options);
        std::ifstream stream(options.output, std::ios::binary);
        copy.assign(std::istreambuf_iterator<char>(stream), {});
    }
    EXPECT_FALSE(bytes[0].empty());
    EXPECT_EQ(bytes[0], bytes[1]);
}

TEST(WriteRecording, UnwritableOutputIsAnOutputError) {
    const auto folder = test_folder();
    for (int i = 0; i < 3; ++i) write_sample_picture(folder / (std::to_string(i) + ".png"), i);
    for (const fs::path& output : {fs::path("/dev/full"), folder / "gone" / "out.rawlog", folder}) {
        ImageFolder sequence(folder, sample_camera(), {});
        RecordingOptions options;
        options.output = output;
        EXPECT_THROW(write_recording(sequence, options), OutputError) << output;
    }
    EXPECT_FALSE(fs::exists("/dev/full.part"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(WriteRecording, AnOlderFileSurvivesAFailedImport) {
    const auto folder = test_folder();
    write_bytes(folder / "out.rawlog", "precious");
    write_bytes(folder / "broken.png", "no picture");
    ImageFolder sequence(folder, sample_camera(), {});
    RecordingOptions options;
    options.output = folder / "out.rawlog";
    EXPECT_THROW(write_recording(sequence, options), InputError);
    EXPECT_EQ(fs::file_size(folder / "out.rawlog"), 8U);
    EXPECT_FALSE(fs::exists(folder / "out.rawlog.part"));
}

void write_video(const fs::path& file) {
    cv::VideoWriter writer(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 20.0,
                           cv::Size(64, 48), false);
    for (int i = 0; i < 5; ++i) writer.write(sample_picture(i));
}

TEST(VideoFile, FramesBecomeImagesAtTheRateOfTheVideo) {
    const auto file = test_folder() / "drive.avi";
    write_video(file);
    if (!fs::exists(file)) GTEST_SKIP() << "this OpenCV cannot write videos";
    VideoFile sequence(file, sample_camera(), std::nullopt);
    EXPECT_EQ(sequence.size(), 5U);
    VideoFile other(file, sample_camera(), 50.0);
    other.next();
    EXPECT_NEAR(other.next()->field.timestamp_s, 0.02, 1e-9);
    std::size_t count = 0;
    while (const auto frame = sequence.next()) {
        EXPECT_NEAR(frame->field.timestamp_s, 0.05 * static_cast<double>(count), 1e-9);
        EXPECT_NEAR(frame->field.image.at(10, 20), 60 + static_cast<int>(count), 2);
        ++count;
    }
    EXPECT_EQ(count, 5U);
}

TEST(VideoFile, WhatIsNoVideoIsNamed) {
    const auto folder = test_folder();
    const std::optional<double> rate;
    expect_names(input_error<VideoFile>(folder / "gone.avi", sample_camera(), rate),
                 {"gone.avi", "no such file"});
    expect_names(input_error<VideoFile>(folder, sample_camera(), rate), {"not a file"});
    write_bytes(folder / "text.avi", "no video at all");
    expect_names(input_error<VideoFile>(folder / "text.avi", sample_camera(), rate),
                 {"cannot be read as a video"});
}

}  // namespace
}  // namespace flownav::io
