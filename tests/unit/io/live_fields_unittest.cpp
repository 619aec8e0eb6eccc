#include "flownav/io/live_fields.h"

#include <gtest/gtest.h>
#include <mrpt/core/Clock.h>

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "flownav/math/units.h"
#include "producer_samples.h"
#include "video_samples.h"

namespace flownav::io {
namespace {

using namespace flownav::testing;
namespace fs = std::filesystem;

std::string video_lines(const fs::path& file) {
    return "grabber_type = ffmpeg\nffmpeg_url = " + file.string() + "\n" + calibration_lines;
}

std::string folder_lines(const fs::path& folder) {
    return "grabber_type = image_dir\nimage_dir_url = " + folder.string() +
           "\nleft_format = image_%03d.png\n" + calibration_lines;
}

bool same_pixels(const Field& field, const cv::Mat& image) {
    if (field.image.width_px != image.cols || field.image.height_px != image.rows) return false;
    for (int v = 0; v < image.rows; ++v) {
        if (!std::equal(image.ptr(v), image.ptr(v) + image.cols, field.image.row(v))) return false;
    }
    return true;
}

void cut(const fs::path& file, double share) {
    fs::resize_file(file, static_cast<std::uintmax_t>(share * static_cast<double>(fs::file_size(file))));
}

TEST(LiveFields, AVideoKeepsItsOwnRate) {
    const fs::path video = producer_folder() / "drive.avi";
    const auto images = noise_images(6);
    write_video(video, images, 20);
    LiveFields live(producer_settings(video_lines(video)));
    const auto fields = all_fields(live);
    EXPECT_EQ(live.error(), "");
    ASSERT_EQ(fields.size(), images.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        EXPECT_NEAR(fields[i].timestamp_s, static_cast<double>(i) / 20, 1e-6);
        EXPECT_TRUE(same_pixels(fields[i], images[i])) << "image " << i;
        EXPECT_EQ(fields[i].camera.mount.height_m, 0.5);
    }
}

TEST(LiveFields, RateAndStartOfAVideoCanBeGiven) {
    const fs::path video = producer_folder() / "drive.avi";
    write_video(video, noise_images(3), 20);
    LiveFields live(producer_settings(video_lines("file://" + video.string()) +
                                      "rate_hz = 12.5\nstart_time_s = 1767225600\n"));
    const auto fields = all_fields(live);
    ASSERT_EQ(fields.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(fields[i].timestamp_s, 1767225600 + static_cast<double>(i) * 0.08, 1e-6);
}

TEST(LiveFields, AColourVideoBecomesGrey) {
    const fs::path video = producer_folder() / "drive.avi";
    cv::VideoWriter writer(video.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('F', 'F', 'V', '1'), 25,
                           {64, 48});
    writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar(0, 0, 255)));
    writer.release();
    LiveFields live(producer_settings(video_lines(video)));
    const auto fields = all_fields(live);
    ASSERT_EQ(fields.size(), 1U);
    EXPECT_NEAR(fields[0].image.at(32, 24), 0.299 * 255, 2) << "red, not blue";
}

TEST(LiveFields, WovenFramesOfAVideoAreSplit) {
    const fs::path video = producer_folder() / "woven.avi";
    std::vector<cv::Mat> frames;
    for (int i = 0; i < 3; ++i) {
        cv::Mat frame(48, 64, CV_8UC1, cv::Scalar(40 + i));
        for (int v = 1; v < 48; v += 2) frame.row(v) = 200 + i;
        frames.push_back(frame);
    }
    write_video(video, frames, 25);
    LiveFields live(producer_settings(video_lines(video) + "camera.interlaced = bottom_first\n"));
    const auto fields = all_fields(live);
    ASSERT_EQ(fields.size(), 6U);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        EXPECT_NEAR(fields[i].timestamp_s, static_cast<double>(i) * 0.02, 1e-6);
        EXPECT_EQ(fields[i].image.height_px, 24);
        EXPECT_EQ(fields[i].image.at(5, 7), (i % 2 == 0 ? 200 : 40) + static_cast<int>(i / 2));
        EXPECT_EQ(fields[i].camera.fy_px, 30.0);
    }
}

TEST(LiveFields, AFolderHasTheRateOfTheIniAndEndsWithItsLastImage) {
    const fs::path folder = producer_folder();
    const auto images = noise_images(105);  // MRPT's own limit is 101
    write_images(folder, images);
    LiveFields live(producer_settings(folder_lines(folder) + "rate_hz = 10\n"));
    const auto fields = all_fields(live);
    EXPECT_EQ(live.error(), "");
    ASSERT_EQ(fields.size(), images.size());
    EXPECT_NEAR(fields[0].timestamp_s, 0.0, 1e-6);
    EXPECT_NEAR(fields[104].timestamp_s, 10.4, 1e-6);
    EXPECT_TRUE(same_pixels(fields[104], images[104]));
}

TEST(LiveFields, StartAndEndIndexChooseAPartOfAFolder) {
    const fs::path folder = producer_folder();
    const auto images = noise_images(6);
    write_images(folder, images);
    LiveFields live(
        producer_settings(folder_lines(folder) + "rate_hz = 10\nstart_index = 2\nend_index = 4\n"));
    const auto fields = all_fields(live);
    EXPECT_EQ(live.error(), "");
    ASSERT_EQ(fields.size(), 3U);
    EXPECT_NEAR(fields[2].timestamp_s, 0.2, 1e-6);
    EXPECT_TRUE(same_pixels(fields[2], images[4]));
}

TEST(LiveFields, AMissingImageOfAFolderIsAnError) {
    const fs::path folder = producer_folder();
    write_images(folder, noise_images(6));
    fs::remove(folder / "image_003.png");
    LiveFields live(producer_settings(folder_lines(folder) + "rate_hz = 10\n"));
    EXPECT_EQ(all_fields(live).size(), 3U);
    EXPECT_TRUE(says(live.error(), "image_003.png is missing", "image_004.png"));
}

TEST(LiveFields, AnImageThatIsNoneIsAnError) {
    const fs::path folder = producer_folder();
    write_images(folder, noise_images(3));
    std::ofstream(folder / "image_001.png") << "text";
    LiveFields live(producer_settings(folder_lines(folder) + "rate_hz = 10\n"));
    EXPECT_EQ(all_fields(live).size(), 1U);
    EXPECT_TRUE(says(live.error(), "after 1 image"));
}

TEST(LiveFields, ACutVideoGivesWhatItHoldsAndSaysSo) {
    const fs::path video = producer_folder() / "drive.avi";
    write_video(video, noise_images(12), 25);
    cut(video, 0.6);
    LiveFields live(producer_settings(video_lines(video)));
    const std::size_t fields = all_fields(live).size();
    EXPECT_GE(fields, 4U);
    EXPECT_LE(fields, 9U);
    EXPECT_TRUE(says(live.error(), "drive.avi", "cut short"));
    EXPECT_FALSE(live.next()) << "and nothing comes later";
}

TEST(LiveFields, AVideoIsReadToItsLastImageWithItsOwnTimes) {
    const fs::path video = producer_folder() / "held_back.mp4";
    VideoSample sample;
    sample.b_frames = 2;
    for (int i = 0; i < 30; ++i) sample.stamps_ms.push_back(40 * i + 7 * (i % 2));
    if (!write_timed_video(video, noise_images(30), sample))
        GTEST_SKIP() << "this FFmpeg cannot write " << video;
    LiveFields live(producer_settings(video_lines(video) + "start_time_s = 100\n"));
    const auto fields = all_fields(live);
    ASSERT_EQ(fields.size(), 30U);
    for (std::size_t i = 0; i < 30; ++i)
        EXPECT_NEAR(fields[i].timestamp_s, 100 + sample.stamps_ms[i] / 1000.0, 1e-6);
    EXPECT_TRUE(live.error().empty()) << live.error();
    EXPECT_TRUE(live.notes().empty());
}

TEST(LiveFields, ARotationTagOfAVideoIsFollowedAndTold) {
    const fs::path video = producer_folder() / "portrait.mp4";
    VideoSample sample;
    sample.stamps_ms = {0, 40, 80};
    sample.rotation_deg = 90;
    if (!write_timed_video(video, noise_images(3), sample))
        GTEST_SKIP() << "this FFmpeg cannot write " << video;
    LiveFields live(producer_settings(video_lines(video)));
    const auto fields = all_fields(live);
    ASSERT_EQ(fields.size(), 3U);
    EXPECT_EQ(fields[0].image.width_px, 48);
    ASSERT_EQ(live.notes().size(), 1U);
    EXPECT_TRUE(says(live.notes()[0], "turned clockwise by 90"));
}

TEST(LiveFields, ARawStreamNeedsItsRate) {
    const fs::path video = producer_folder() / "raw.mjpeg";
    VideoSample sample;
    sample.format = "mjpeg";
    sample.codec = "mjpeg";
    sample.stamps_ms = {0, 40, 80};
    if (!write_timed_video(video, noise_images(3), sample))
        GTEST_SKIP() << "this FFmpeg cannot write " << video;
    EXPECT_TRUE(says(reason_not_to_open(video_lines(video)), "raw.mjpeg", "rate_hz"));
    LiveFields live(producer_settings(video_lines(video) + "rate_hz = 10\n"));
    const auto fields = all_fields(live);
    ASSERT_EQ(fields.size(), 3U);
    EXPECT_NEAR(fields[2].timestamp_s, 0.2, 1e-6);
}

TEST(LiveFields, APictureOfAFolderThatIsCutShortIsAnError) {
    const fs::path folder = producer_folder();
    for (int i = 0; i < 3; ++i)
        cv::imwrite((folder / ("image_00" + std::to_string(i) + ".jpg")).string(), noise_images(1)[0]);
    fs::resize_file(folder / "image_001.jpg", fs::file_size(folder / "image_001.jpg") / 2);
    LiveFields live(producer_settings("grabber_type = image_dir\nimage_dir_url = " + folder.string() +
                                      "\nleft_format = image_%03d.jpg\nrate_hz = 10\n" + calibration_lines));
    EXPECT_EQ(all_fields(live).size(), 1U);
    EXPECT_TRUE(says(live.error(), "image_001.jpg", "cut short"));
}

TEST(LiveFields, AStreamHasTheTimesOfItsGrabberAndFailsWhenItEnds) {
    const fs::path video = producer_folder() / "drive.avi";
    write_video(video, noise_images(4), 25);
    const double before_s = mrpt::Clock::nowDouble();
    LiveFields live(producer_settings(video_lines("async:file://" + video.string())));
    const auto fields = all_fields(live);
    ASSERT_EQ(fields.size(), 4U) << live.error();
    for (const Field& field : fields) {
        EXPECT_GE(field.timestamp_s, before_s - 1);
        EXPECT_LE(field.timestamp_s, mrpt::Clock::nowDouble() + 1);
    }
    EXPECT_TRUE(says(live.error(), "after 4 images", "end of the stream"));
}

TEST(LiveFields, SourcesThatAreNotThereAreToldWithTheirName) {
    const fs::path folder = producer_folder();
    EXPECT_TRUE(says(reason_not_to_open(video_lines(folder / "none.avi")), "none.avi: no such file"));
    EXPECT_TRUE(says(reason_not_to_open(video_lines(folder)), "is not a file"));
    EXPECT_TRUE(says(reason_not_to_open(folder_lines(folder / "none") + "rate_hz = 5\n"), "no such folder"));
    EXPECT_TRUE(
        says(reason_not_to_open(folder_lines(folder) + "rate_hz = 5\n"), "holds no image image_000.png"));
    EXPECT_TRUE(says(reason_not_to_open("grabber_type = rawlog\nrawlog_file = none.rawlog\n"),
                     "none.rawlog: no such file"));
    EXPECT_TRUE(says(reason_not_to_open("grabber_type = opencv\ncv_camera_index = 99\n"), "opencv",
                     "cannot be opened"));
    EXPECT_TRUE(says(reason_not_to_open("grabber_type = telescope\n"), "telescope"));
    std::ofstream(folder / "text.avi") << "This is no video.\n";
    EXPECT_TRUE(says(reason_not_to_open(video_lines(folder / "text.avi")), "cannot be read as a video"));
}

TEST(LiveFields, AFolderWithoutRateIsAnError) {
    const fs::path folder = producer_folder();
    write_images(folder, noise_images(2));
    EXPECT_TRUE(says(reason_not_to_open(folder_lines(folder)), "rate_hz is missing"));
}

TEST(LiveFields, AnImageFormatWithoutItsOneNumberIsAnError) {
    const fs::path folder = producer_folder();
    const std::string lines =
        "grabber_type = image_dir\nrate_hz = 5\nimage_dir_url = " + folder.string() + "\n";
    for (const char* format : {"image.png", "image_%s.png", "%d_%d.png", "image_%05d%n.png"}) {
        EXPECT_TRUE(says(reason_not_to_open(lines + "left_format = " + format + "\n"), "left_format"))
            << format;
    }
}

TEST(LiveFields, ImagesWithoutCalibrationNameTheKeys) {
    const fs::path video = producer_folder() / "drive.avi";
    write_video(video, noise_images(3), 25);
    LiveFields live(producer_settings("grabber_type = ffmpeg\nffmpeg_url = " + video.string() + "\n"));
    EXPECT_TRUE(all_fields(live).empty());
    EXPECT_TRUE(says(live.error(), "camera.fx_px", "camera.height_m"));
}

TEST(LiveFields, ThePoseOfTheDriverSectionIsTheCameras) {
    const fs::path video = producer_folder() / "drive.avi";
    write_video(video, noise_images(2), 25);
    LiveFields live(
        producer_settings("grabber_type = ffmpeg\nffmpeg_url = " + video.string() +
                          "\ncamera.fx_px = 60\ncamera.fy_px = 60\ncamera.cx_px = 31.5\ncamera.cy_px = 23.5\n"
                          "pose_x = 0.1\npose_z = 0.62\npose_yaw = -90\npose_roll = -115\n"));
    const auto fields = all_fields(live);
    ASSERT_EQ(fields.size(), 2U) << live.error();
    EXPECT_NEAR(fields[0].camera.mount.height_m, 0.62, 1e-6);
    EXPECT_NEAR(fields[0].camera.mount.forward_m, 0.1, 1e-6);
    EXPECT_NEAR(fields[0].camera.mount.pitch_rad, 25 * degree_rad, 1e-6);
}

}  // namespace
}  // namespace flownav::io
