#include "flownav/io/kitti.h"

#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "flownav/io/errors.h"
#include "flownav/math/units.h"
#include "import_samples.h"
#include "rawlog_files.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;
using namespace flownav::testing;

constexpr auto rectified = "S_rect_02: 64 48\nP_rect_02: 60 0 31.5 3.6 0 61 23.5 0 0 0 1 0\n";
constexpr auto as_taken =
    "S_02: 80 50\nK_02: 70 0 41 0 71 26 0 0 1\nD_02: -0.3 0.1 0.001 0.002 -0.05\nT_02: 0.06 0 0\n";

std::string ten_digits(int number) {
    const std::string digits = std::to_string(number);
    return std::string(10 - digits.size(), '0') + digits;
}

/// A raw drive "0005" of kind "sync" or "extract" with these images and this calibration.
fs::path raw_drive(const std::vector<int>& numbers, const std::string& calibration,
                   const std::string& kind = "sync", const char* camera = "image_02",
                   cv::Size size = {64, 48}) {
    const fs::path day = test_folder() / "2011_09_26";
    const fs::path drive = day / ("2011_09_26_drive_0005_" + kind);
    fs::create_directories(drive / camera / "data");
    for (const int number : numbers)
        cv::imwrite((drive / camera / "data" / (ten_digits(number) + ".png")).string(),
                    cv::Mat(size, CV_8UC1, cv::Scalar(10 + number)));
    write_bytes(day / "calib_cam_to_cam.txt", "calib_time: 09-Jan-2012 13:57:47\n" + calibration);
    return drive;
}

fs::path day_of(const fs::path& drive) {
    return drive.parent_path();
}

/// Times at 10 Hz from 13:02:25 on.
std::string stamps(int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += "2011-09-26 13:02:25." + std::to_string(i) + "00000000\n";
    return text;
}

constexpr double start_s = 1317042145.0;

void write_oxts(const fs::path& drive, const std::vector<int>& numbers) {
    fs::create_directories(drive / "oxts" / "data");
    for (const int number : numbers)
        write_bytes(drive / "oxts" / "data" / (ten_digits(number) + ".txt"),
                    std::to_string(49.0 + 0.00001 * number) + " 8.4 116 0 0 1.5707963267949 5 5 5\n");
}

TEST(KittiRawDrive, MissingImagesKeepTheTimesOfTheirNumbers) {
    const fs::path drive = raw_drive({0, 1, 3, 4}, rectified);
    KittiRaw by_rate(day_of(drive), "0005", 10, {});
    expect_times(times_of(by_rate), {0, 0.1, 0.3, 0.4});
    EXPECT_TRUE(some_says(by_rate.notes(), {"no timestamps.txt", "10 images a second"}));
    EXPECT_TRUE(some_says(by_rate.problems(), {"1 of 5 images are missing", "number 2"}));
    write_bytes(drive / "image_02" / "timestamps.txt", stamps(5));
    KittiRaw by_file(day_of(drive), "0005", 10, {});
    expect_times(times_of(by_file), {start_s, start_s + 0.1, start_s + 0.3, start_s + 0.4});
    EXPECT_TRUE(some_says(by_file.problems(), {"1 of 5 images are missing"}));
    EXPECT_TRUE(by_file.notes().empty());
}

TEST(KittiRawDrive, EmptyLinesOfTheTimesAreLostImages) {
    const fs::path drive = raw_drive({0, 1, 2, 3}, rectified);
    std::string text = stamps(4);
    const auto second = text.find('\n') + 1;
    text.erase(second, text.find('\n', second) - second);
    write_bytes(drive / "image_02" / "timestamps.txt", text);
    KittiRaw sequence(day_of(drive), "0005", 10, {});
    expect_times(times_of(sequence), {start_s, start_s + 0.2, start_s + 0.3});
    EXPECT_TRUE(some_says(sequence.problems(), {"0000000001.png", "no time"}));
}

TEST(KittiRawDrive, AMissingFileOfOxtsCostsOnePoseAndIsTold) {
    const fs::path drive = raw_drive({0, 1, 2, 3}, rectified);
    write_oxts(drive, {0, 2, 3});
    KittiRaw sequence(day_of(drive), "0005", 10, {});
    std::vector<std::optional<Pose2>> poses;
    while (const auto frame = sequence.next()) poses.push_back(frame->T_start_robot);
    ASSERT_EQ(poses.size(), 4U);
    EXPECT_TRUE(poses[0]);
    EXPECT_FALSE(poses[1]);
    ASSERT_TRUE(poses[3]);
    EXPECT_NEAR(poses[3]->x_m, 3 * 1.113, 0.01);
    EXPECT_TRUE(some_says(sequence.problems(), {"1 of 4 files are missing", "0000000001.txt"}));
}

TEST(KittiRawDrive, ImagesOfAnotherSizeHaveTheCalibrationScaled) {
    const fs::path drive = raw_drive({0, 1}, rectified, "sync", "image_02", {32, 24});
    KittiRaw sequence(day_of(drive), "0005", 10, {});
    const auto frame = sequence.next();
    ASSERT_TRUE(frame);
    EXPECT_NEAR(frame->field.camera.fx_px, 30, 1e-9);
    EXPECT_NEAR(frame->field.camera.fy_px, 30.5, 1e-9);
    EXPECT_NEAR(frame->field.camera.cx_px, 15.5, 1e-9);
    EXPECT_NEAR(frame->field.camera.cy_px, 11.5, 1e-9);
    EXPECT_TRUE(some_says(sequence.notes(), {"64 x 48", "32 x 24", "scaled"}));
}

TEST(KittiRawDrive, ImagesThatAreNotRectifiedNeedTheirOwnCalibration) {
    const fs::path drive =
        raw_drive({0, 1}, std::string(rectified) + as_taken, "extract", "image_02", {80, 50});
    KittiRaw sequence(day_of(drive), "0005", 10, {});
    const auto frame = sequence.next();
    ASSERT_TRUE(frame);
    const CameraModel& camera = frame->field.camera;
    EXPECT_DOUBLE_EQ(camera.fx_px, 70);
    EXPECT_DOUBLE_EQ(camera.cy_px, 26);
    EXPECT_DOUBLE_EQ(camera.distortion[0], -0.3);
    EXPECT_DOUBLE_EQ(camera.distortion[4], -0.05);
    EXPECT_NEAR(camera.mount.left_m, 0.06, 1e-12);
    EXPECT_TRUE(some_says(sequence.notes(), {"not rectified", "K_02", "D_02"}));
}

TEST(KittiRawDrive, ImagesThatTheCalibrationDoesNotFitAreRefused) {
    const auto refusal = [](const std::string& calibration, cv::Size size) {
        const fs::path drive = raw_drive({0}, calibration, "extract", "image_02", size);
        try {
            KittiRaw(day_of(drive), "0005", 10, {});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    expect_parts(refusal(std::string("S_02: 80 50\n") + rectified, {80, 50}),
                 {"not rectified", "K_02", "_sync"});
    expect_parts(refusal(rectified, {80, 50}), {"80 x 50", "S_rect_02 is 64 x 48", "not theirs"});
    expect_parts(refusal("S_rect_02: 1242 375\nP_rect_02: 721 0 609 0 0 721 172 0 0 0 1 0\n", {1392, 512}),
                 {"not rectified", "K_02"});
}

TEST(KittiRawDrive, PosesOfADriveThatIsNotSynchronisedAreTakenByTime) {
    const fs::path drive =
        raw_drive({0, 1}, std::string(rectified) + as_taken, "extract", "image_02", {80, 50});
    write_bytes(drive / "image_02" / "timestamps.txt", stamps(2));
    write_oxts(drive, {0, 1, 2, 3});
    KittiRaw without(day_of(drive), "0005", 10, {});
    EXPECT_FALSE(without.next()->T_start_robot);
    EXPECT_TRUE(some_says(without.notes(), {"oxts", "not synchronised"}));
    write_bytes(
        drive / "oxts" / "timestamps.txt",
        "2011-09-26 13:02:24.98\n2011-09-26 13:02:25.03\n2011-09-26 13:02:25.08\n2011-09-26 13:02:25.13\n");
    KittiRaw sequence(day_of(drive), "0005", 10, {});
    const auto first = sequence.next();
    const auto second = sequence.next();
    ASSERT_TRUE(first->T_start_robot && second->T_start_robot);
    EXPECT_NEAR(second->T_start_robot->x_m - first->T_start_robot->x_m, 2 * 1.113, 0.01);
}

TEST(KittiRawDrive, TheFirstCameraWithImagesIsTaken) {
    const fs::path drive = raw_drive({0, 1}, rectified);
    fs::create_directories(drive / "image_00" / "data");
    KittiRaw sequence(day_of(drive), "0005", 10, {});
    EXPECT_EQ(times_of(sequence).size(), 2U);
}

TEST(KittiRawDrive, TheMountIsThatOfTheDay) {
    EXPECT_NEAR(kitti_mount("2011_09_26").height_m, 1.66, 1e-12);
    EXPECT_NEAR(kitti_mount("00").roll_rad, -1.4 * degree_rad, 1e-12);
    EXPECT_NEAR(kitti_mount("another").height_m, 1.65, 1e-12);
}

TEST(KittiSequence, ColourImagesAreTakenWhenThereAreNoGreyOnes) {
    const fs::path folder = test_folder();
    const fs::path sequence_folder = folder / "sequences" / "00";
    for (int i = 0; i < 3; ++i)
        write_sample_picture(sequence_folder / "image_2" / ("00000" + std::to_string(i) + ".png"), i);
    write_bytes(sequence_folder / "calib.txt", "P2: 60 0 31.5 3.6 0 61 23.5 0 0 0 1 0\n");
    write_bytes(sequence_folder / "times.txt",
                "\xEF\xBB\xBF"
                "0.0\r\n0.1\r\n0.2\r\n0.3\r\n");
    KittiOdometry sequence(folder, "00", {});
    expect_times(times_of(sequence), {0, 0.1, 0.2});
    EXPECT_TRUE(some_says(sequence.notes(), {"no image_0", "image_2"}));
    EXPECT_TRUE(some_says(sequence.problems(), {"1 of 4 images are missing", "number 3"}));
}

}  // namespace
}  // namespace flownav::io
