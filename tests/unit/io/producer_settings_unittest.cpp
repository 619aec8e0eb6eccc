#include "flownav/io/producer_settings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "producer_samples.h"

namespace flownav::io {
namespace {

using namespace flownav::testing;

const std::string rawlog_lines = "grabber_type = rawlog\nrawlog_file = drive.rawlog\n";

std::string complaint(const std::string& lines) {
    try {
        producer_settings(lines);
    } catch (const config::ConfigError& error) {
        return error.what();
    }
    return "no complaint";
}

TEST(ProducerSettings, DefaultsAreThoseOfTheDocumentation) {
    const auto settings = producer_settings(rawlog_lines);
    EXPECT_EQ(settings.section, "FLOW");
    EXPECT_EQ(settings.source, "drive.rawlog");
    EXPECT_EQ(settings.label_prefix, "FLOW");
    EXPECT_TRUE(settings.use_odometry);
    EXPECT_FALSE(settings.publish_image);
    EXPECT_FALSE(settings.paced);
    EXPECT_FALSE(settings.rate_hz);
    EXPECT_EQ(settings.start_time_s, 0.0);
    EXPECT_EQ(settings.end_wait_s, 5.0);
    EXPECT_EQ(settings.config.camera.camera_label, "CAMERA1");
}

TEST(ProducerSettings, KeysAreReadWithTheirComments) {
    const auto settings = producer_settings(
        "grabber_type = FFmpeg   // a stream\nffmpeg_url = rtsp://10.0.0.7/front\n"
        "label_prefix = LEFT\npublish_image = true\nuse_odometry = 0\npaced = yes\n"
        "rate_hz = 12.5 // of the camera\nstart_time_s = 1767225600\nend_wait_s = 0\n");
    EXPECT_EQ(settings.grabber_type, "ffmpeg");
    EXPECT_EQ(settings.source, "rtsp://10.0.0.7/front");
    EXPECT_EQ(settings.label_prefix, "LEFT");
    EXPECT_TRUE(settings.publish_image);
    EXPECT_FALSE(settings.use_odometry);
    EXPECT_TRUE(settings.paced);
    EXPECT_EQ(settings.rate_hz, 12.5);
    EXPECT_EQ(settings.start_time_s, 1767225600.0);
    EXPECT_EQ(settings.end_wait_s, 0.0);
}

TEST(ProducerSettings, LinesCommentedOutAreNoKeys) {
    const auto settings = producer_settings(
        "// rate_hz = 5\n//camera.nonsense = 1\n# paced = yes\n; paced = yes\n" + rawlog_lines);
    EXPECT_FALSE(settings.rate_hz);
    EXPECT_FALSE(settings.paced);
}

TEST(ProducerSettings, TheSectionOverridesTheIniOfFlownav) {
    const auto ini = producer_folder() / "robot.ini";
    std::ofstream(ini) << "[camera]\nheight_m = 0.7\npitch_deg = 20\n[flow]\nblocks = 200\n";
    const auto settings = producer_settings("camera.height_m = 0.62\nflownav_config = " + ini.string() +
                                            "\n" + rawlog_lines + "obstacles.tau_px = 2\n");
    EXPECT_EQ(settings.config.camera.height_m, 0.62);
    EXPECT_EQ(settings.config.camera.pitch_deg, 20.0);
    EXPECT_EQ(settings.config.pipeline.flow.blocks, 200);
    EXPECT_EQ(settings.config.pipeline.obstacles.tau_px, 2.0);
}

TEST(ProducerSettings, MrptsKeyForTheLabelOfTheImagesIsUnderstood) {
    const auto settings = producer_settings(rawlog_lines + "rawlog_camera_sensor_label = FRONT\n");
    EXPECT_EQ(settings.config.camera.camera_label, "FRONT");
}

TEST(ProducerSettings, KeysOfMrptPassInUpperAndLowerCase) {
    const auto settings =
        producer_settings(rawlog_lines +
                          "process_rate = 30\nsensorLabel = X\nmax_queue_len = 10\nCapture_Grayscale = 1\n"
                          "dc1394_shutter_mode = 1\nflycap_camera_index = 2\n");
    EXPECT_EQ(settings.camera_keys.at("capture_grayscale"), "1");
    EXPECT_EQ(settings.camera_keys.at("dc1394_shutter_mode"), "1");
    EXPECT_EQ(settings.camera_keys.count("grab_decimation"), 0U);
}

TEST(ProducerSettings, AnUnknownKeyNamesTheNearestKnownOne) {
    EXPECT_TRUE(says(complaint(rawlog_lines + "publish_images = 1\n"), "section FLOW", "publish_images",
                     "publish_image"));
    EXPECT_TRUE(says(complaint(rawlog_lines + "ffmpeg_ulr = x\n"), "ffmpeg_url"));
    EXPECT_TRUE(says(complaint(rawlog_lines + "camera.hight_m = 1\n"), "camera.height_m"));
    EXPECT_TRUE(says(complaint(rawlog_lines + "height_m = 1\n"), "camera.height_m"));
    EXPECT_TRUE(says(complaint(rawlog_lines + "blind_cone = 0.1\n"), "flow.focus_exclusion"));
}

TEST(ProducerSettings, EarlierNamesOfKeysAreRead) {
    const auto settings =
        producer_settings(rawlog_lines + "flow.blind_cone = 0.125\nnavigation.plan = stuck\n");
    EXPECT_EQ(settings.config.pipeline.flow.focus_exclusion, 0.125);
    EXPECT_EQ(settings.config.recovery.replan, nav::ReplanPolicy::WhenStuck);
}

TEST(ProducerSettings, ValuesOutOfRangeNameKeyValueAndRange) {
    EXPECT_TRUE(says(complaint(rawlog_lines + "rate_hz = 0\n"), "rate_hz = 0", "0.01 .. 10000"));
    EXPECT_TRUE(says(complaint(rawlog_lines + "paced = maybe\n"), "paced = maybe", "true"));
    EXPECT_TRUE(
        says(complaint(rawlog_lines + "camera.height_m = -1\n"), "camera.height_m", "-1", "0.01 .. 20"));
}

TEST(ProducerSettings, DecimationIsRefused) {
    EXPECT_TRUE(says(complaint(rawlog_lines + "grab_decimation = 5\n"), "grab_decimation = 5", "allowed"));
    EXPECT_EQ(complaint(rawlog_lines + "grab_decimation = 1\n"), "no complaint");
}

TEST(ProducerSettings, WhatTheGrabberNeedsMustBeThere) {
    EXPECT_TRUE(says(complaint(""), "grabber_type is missing"));
    EXPECT_TRUE(says(complaint("grabber_type = rawlog\n"), "rawlog_file is missing"));
    EXPECT_TRUE(says(complaint("grabber_type = ffmpeg\n"), "ffmpeg_url is missing"));
    EXPECT_TRUE(says(complaint("grabber_type = image_dir\n"), "image_dir_url is missing"));
    EXPECT_TRUE(says(complaint(rawlog_lines + "flownav_config = none.ini\n"), "none.ini"));
}

TEST(ProducerSettings, TheSectionOfAFileIsFoundByItsDriver) {
    const auto ini = producer_folder() / "grabber.ini";
    std::ofstream(ini) << "[global]\nGRABBER_PERIOD_MS = 50\n[LASER]\ndriver = CHokuyoURG\n"
                          "[FRONT]\ndriver = CFlowObstacleSensor\n"
                       << rawlog_lines;
    EXPECT_EQ(read_producer_settings(ini.string()).section, "FRONT");
    std::ofstream(ini, std::ios::app) << "[REAR]\ndriver = CFlowObstacleSensor\n" << rawlog_lines;
    EXPECT_THROW(read_producer_settings(ini.string()), config::ConfigError);
    EXPECT_EQ(read_producer_settings(ini.string(), "REAR").section, "REAR");
    EXPECT_THROW(read_producer_settings(ini.string(), "LEFT"), config::ConfigError);
    EXPECT_THROW(read_producer_settings(ini.string() + ".none"), config::ConfigError);
}

}  // namespace
}  // namespace flownav::io
