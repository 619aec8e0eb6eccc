#include "flownav/report/drive_video.h"

#include <gtest/gtest.h>

#include <opencv2/videoio.hpp>

#include "../support/temporary_folder.h"
#include "flownav/io/output_file.h"
#include "step_samples.h"

namespace flownav::report {
namespace {

using testing::bytes_of;
using testing::pal_field;
using testing::step_at;
using testing::TemporaryFolder;

const mrpt::maps::COccupancyGridMap2D& unknown_map() {
    static const mrpt::maps::COccupancyGridMap2D map(-2, 2, -2, 2, 0.1F);
    return map;
}

/// Number of video frames for fields with these time stamps.
std::uint64_t frames_of(const std::vector<double>& times_s) {
    const TemporaryFolder folder;
    DriveVideo video(folder / "drive.mp4", 4.0);
    for (std::size_t i = 0; i < times_s.size(); ++i) {
        Field field = pal_field(static_cast<int>(i));
        field.timestamp_s = times_s[i];
        video.write(field, step_at(static_cast<int>(i)), unknown_map());
    }
    video.close();
    cv::VideoCapture written((folder / "drive.mp4").string(), cv::CAP_FFMPEG);
    EXPECT_EQ(written.get(cv::CAP_PROP_FRAME_COUNT), static_cast<double>(video.frames()));
    EXPECT_EQ(written.get(cv::CAP_PROP_FPS), DriveVideo::rate_hz);
    return video.frames();
}

std::vector<double> times(double rate_hz, int count) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back(1e9 + i / rate_hz);
    return result;
}

TEST(DriveVideo, RunsAsFastAsTheDriveWhateverTheCamerasRate) {
    EXPECT_EQ(frames_of(times(25.0, 10)), 10U);
    EXPECT_EQ(frames_of(times(50.0, 19)), 10U) << "every second field";
    EXPECT_NEAR(static_cast<double>(frames_of(times(10.0, 5))), 11.0, 1.0)
        << "each field for a tenth of a second";
}

TEST(DriveVideo, OfALongPauseOneSecondIsShown) {
    EXPECT_NEAR(static_cast<double>(frames_of({100.0, 100.04, 4000.0, 4000.04})), 2 + 25 + 2, 1.0);
}

TEST(DriveVideo, ShowsTheFieldBesideTheMap) {
    const TemporaryFolder folder;
    DriveVideo video(folder / "drive.mp4", 4.0);
    for (int i = 0; i < 3; ++i) video.write(pal_field(i), step_at(i), unknown_map());
    video.close();
    cv::VideoCapture written((folder / "drive.mp4").string(), cv::CAP_FFMPEG);
    cv::Mat picture;
    ASSERT_TRUE(written.read(picture));
    ASSERT_GT(picture.cols, 768 + 500);
    const cv::Vec3b unknown = picture.at<cv::Vec3b>(60, 768 + 60);
    for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(unknown[channel], 127, 6) << "grey: not seen yet";
}

TEST(DriveVideo, ANewImageSizeKeepsTheVideosSize) {
    const TemporaryFolder folder;
    DriveVideo video(folder / "drive.mp4", 4.0);
    video.write(pal_field(0), step_at(0), unknown_map());
    const std::vector<std::uint8_t> pixels(1241UL * 376, 90);
    Field wide = pal_field(1);
    wide.image = {pixels.data(), 1241, 376, 1241};
    wide.camera.fx_px = wide.camera.fy_px = 700;
    video.write(wide, step_at(1), unknown_map());
    EXPECT_NO_THROW(video.close());
    EXPECT_EQ(video.frames(), 2U);
}

TEST(DriveVideo, TheSameDriveGivesTheSameBytes) {
    const TemporaryFolder folder;
    for (const char* name : {"a.mp4", "b.mp4"}) {
        DriveVideo video(folder / name, 4.0);
        for (int i = 0; i < 6; ++i) video.write(pal_field(i), step_at(i), unknown_map());
        video.close();
    }
    EXPECT_EQ(bytes_of(folder / "a.mp4"), bytes_of(folder / "b.mp4"));
    EXPECT_GT(bytes_of(folder / "a.mp4").size(), 1000U);
}

TEST(DriveVideo, AFileThatCannotBeWrittenIsNamed) {
    try {
        const DriveVideo video("/nowhere/drive.mp4", 4.0);
        FAIL() << "no error";
    } catch (const io::OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("/nowhere/drive.mp4"), std::string::npos);
    }
}

}  // namespace
}  // namespace flownav::report
