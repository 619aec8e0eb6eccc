#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "flownav/io/errors.h"
#include "flownav/io/video_file.h"
#include "import_samples.h"
#include "rawlog_files.h"
#include "video_samples.h"

namespace flownav::io {
namespace {

namespace fs = std::filesystem;
using namespace flownav::testing;

/// Images of 64 x 48 that are bright at the top left, and brighter from image to image.
std::vector<cv::Mat> corner_images(int count) {
    std::vector<cv::Mat> images;
    for (int i = 0; i < count; ++i) {
        cv::Mat image(48, 64, CV_8UC1, cv::Scalar(60 + 2 * i));
        image(cv::Rect(0, 0, 16, 16)).setTo(230);
        images.push_back(image);
    }
    return images;
}

std::vector<double> in_seconds(const std::vector<int>& stamps_ms) {
    std::vector<double> times_s;
    for (const int stamp : stamps_ms) times_s.push_back((stamp - stamps_ms.front()) / 1000.0);
    return times_s;
}

std::string refusal_of(const fs::path& file) {
    try {
        VideoFile(file, sample_camera(), std::nullopt);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

#define WRITE_OR_SKIP(file, images, sample) \
    if (!write_timed_video(file, images, sample)) GTEST_SKIP() << "this FFmpeg cannot write " << (file)

TEST(Video, TimeStampsOfTheContainerAreKept) {
    VideoSample sample;
    sample.stamps_ms = {0, 33, 66, 130, 135, 300, 333, 366};
    const fs::path file = test_folder() / "phone.mp4";
    WRITE_OR_SKIP(file, corner_images(8), sample);
    VideoFile sequence(file, sample_camera(), std::nullopt);
    EXPECT_EQ(sequence.size(), 8U);
    expect_times(times_of(sequence), in_seconds(sample.stamps_ms));
    EXPECT_TRUE(sequence.notes().empty());
    EXPECT_TRUE(sequence.problems().empty());
}

TEST(Video, ImagesThatTheDecoderHoldsBackComeWithTheirTimes) {
    VideoSample sample;
    sample.b_frames = 2;
    for (int i = 0; i < 30; ++i) sample.stamps_ms.push_back(40 * i + (i % 3));
    const fs::path file = test_folder() / "held.mp4";
    WRITE_OR_SKIP(file, corner_images(30), sample);
    VideoFile sequence(file, sample_camera(), std::nullopt);
    expect_times(times_of(sequence), in_seconds(sample.stamps_ms));
    EXPECT_TRUE(sequence.problems().empty());
}

TEST(Video, ARotationTagIsFollowedAndTold) {
    const std::vector<std::pair<int, cv::Point>> turns = {
        {0, {4, 4}}, {90, {43, 4}}, {180, {59, 43}}, {270, {4, 59}}};
    for (const auto& [degrees, bright] : turns) {
        VideoSample sample;
        sample.stamps_ms = {0, 40};
        sample.rotation_deg = degrees;
        const fs::path file = test_folder() / "turned.mp4";
        WRITE_OR_SKIP(file, corner_images(2), sample);
        VideoFile sequence(file, sample_camera(), std::nullopt);
        const auto frame = sequence.next();
        ASSERT_TRUE(frame);
        EXPECT_EQ(frame->field.image.width_px, degrees % 180 == 0 ? 64 : 48);
        EXPECT_GT(frame->field.image.at(bright.x, bright.y), 190) << degrees;
        times_of(sequence);
        EXPECT_EQ(some_says(sequence.notes(), {"turned clockwise", "rotation tag"}), degrees != 0);
    }
}

TEST(Video, ARawStreamAsksForItsRate) {
    VideoSample sample;
    sample.format = "mjpeg";
    sample.codec = "mjpeg";
    sample.stamps_ms = {0, 40, 80};
    const fs::path file = test_folder() / "raw.mjpeg";
    WRITE_OR_SKIP(file, corner_images(3), sample);
    expect_parts(refusal_of(file), {"raw.mjpeg", "--rate"});
    VideoFile sequence(file, sample_camera(), 20.0);
    expect_times(times_of(sequence), {0, 0.05, 0.10});
}

TEST(Video, TimesThatNoCameraHasAreTold) {
    VideoSample sample;
    sample.format = "mov";
    sample.codec = "mjpeg";
    sample.rate_hz = 1200000;
    sample.stamps_ms = {0, 0, 0, 0};
    const fs::path file = test_folder() / "fast.mov";
    WRITE_OR_SKIP(file, corner_images(4), sample);
    VideoFile sequence(file, sample_camera(), std::nullopt);
    times_of(sequence);
    EXPECT_TRUE(some_says(sequence.problems(), {"fast.mov", "apart", "--rate"}));
    sample.rate_hz = 0;
    sample.stamps_ms = {0, 900, 1800, 2700};
    WRITE_OR_SKIP(file, corner_images(4), sample);
    VideoFile slow(file, sample_camera(), std::nullopt);
    expect_times(times_of(slow), in_seconds(sample.stamps_ms));
    EXPECT_TRUE(some_says(slow.notes(), {"0.9 s apart", "motion.gap_max_s"}));
}

TEST(Video, ARateThatContradictsTheVideoIsTold) {
    VideoSample sample;
    sample.stamps_ms = {0, 40, 80};
    const fs::path file = test_folder() / "drive.mp4";
    WRITE_OR_SKIP(file, corner_images(3), sample);
    VideoFile sequence(file, sample_camera(), 50.0);
    expect_times(times_of(sequence), {0, 0.02, 0.04});
    EXPECT_TRUE(some_says(sequence.notes(), {"25 images a second", "--rate 50"}));
}

TEST(Video, ImagesThatAnAviLeavesOutAreNotMissed) {
    VideoSample sample;
    sample.format = "avi";
    sample.codec = "mjpeg";
    sample.rate_hz = 50;
    sample.stamps_ms = {0, 20, 40, 160, 180, 400};
    const fs::path file = test_folder() / "dropped.avi";
    WRITE_OR_SKIP(file, corner_images(6), sample);
    VideoFile sequence(file, sample_camera(), std::nullopt);
    expect_times(times_of(sequence), in_seconds(sample.stamps_ms));
    EXPECT_TRUE(sequence.problems().empty());
}

TEST(Video, AVideoThatIsCutShortIsTold) {
    VideoSample sample;
    sample.format = "avi";
    sample.codec = "mjpeg";
    sample.rate_hz = 25;
    for (int i = 0; i < 20; ++i) sample.stamps_ms.push_back(40 * i);
    const fs::path file = test_folder() / "cut.avi";
    std::vector<cv::Mat> images = corner_images(20);
    for (cv::Mat& image : images) cv::randu(image, 0, 255);
    WRITE_OR_SKIP(file, images, sample);
    fs::resize_file(file, fs::file_size(file) * 6 / 10);
    VideoFile sequence(file, sample_camera(), std::nullopt);
    EXPECT_LT(times_of(sequence).size(), 20U);
    EXPECT_TRUE(some_says(sequence.problems(), {"cut short", "20 images"}));
}

TEST(Video, WovenFieldsAreOffered) {
    VideoSample sample;
    sample.format = "matroska";
    sample.codec = "mpeg2video";
    sample.rate_hz = 25;
    sample.top_field_first = true;
    for (int i = 0; i < 6; ++i) sample.stamps_ms.push_back(40 * i);
    const fs::path file = test_folder() / "woven.mkv";
    WRITE_OR_SKIP(file, corner_images(6), sample);
    VideoFile sequence(file, sample_camera(), std::nullopt);
    EXPECT_EQ(times_of(sequence).size(), 6U);
    EXPECT_TRUE(some_says(sequence.notes(), {"woven", "--interlaced top_first"}));
    config::CameraConfig woven = sample_camera();
    woven.interlaced = config::Interlaced::TopFirst;
    VideoFile configured(file, woven, std::nullopt);
    times_of(configured);
    EXPECT_FALSE(some_says(configured.notes(), {"woven"}));
}

}  // namespace
}  // namespace flownav::io
