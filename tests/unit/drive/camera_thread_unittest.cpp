#include "flownav/drive/camera_thread.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <thread>

#include "producer_samples.h"

namespace flownav::drive {
namespace {

using namespace flownav::testing;

constexpr double rate_hz = 50.0;

/// Images of a folder, at a rate.
io::ProducerSettings images(int count, double images_hz) {
    const auto folder = producer_folder();
    write_images(folder, noise_images(count));
    return producer_settings("grabber_type = image_dir\nimage_dir_url = " + folder.string() +
                             "\nleft_format = image_%03d.png\nrate_hz = " + std::to_string(images_hz) + "\n" +
                             calibration_lines);
}

io::ProducerSettings three_images() {
    return images(3, rate_hz);
}

/// Waits for the end of the feed and returns its message.
std::string end_of(CameraThread& camera) {
    while (camera.end().empty()) std::this_thread::yield();
    return camera.end();
}

TEST(CameraThread, PlaysARecordingAtItsOwnPaceInTheTimeOfTheDrive) {
    const SteadyClock clock;
    const double began_s = clock.now_s();
    std::vector<Field> fields;
    CameraThread camera(three_images(), clock,
                        [&fields](const Field& field, const pipeline::Step&) { fields.push_back(field); });
    EXPECT_EQ(end_of(camera), "the camera's source has ended");
    EXPECT_GE(clock.now_s() - began_s, 2.0 / rate_hz - 1e-6);
    ASSERT_EQ(fields.size(), 3U);
    EXPECT_GE(fields[0].timestamp_s, began_s);
    for (std::size_t i = 1; i < fields.size(); ++i)
        EXPECT_NEAR(fields[i].timestamp_s - fields[i - 1].timestamp_s, 1.0 / rate_hz, 1e-6);
    const auto arrived = camera.arrived();
    ASSERT_EQ(arrived.size(), 3U);
    for (std::size_t i = 0; i < arrived.size(); ++i)
        EXPECT_EQ(arrived[i].report.timestamp_s, fields[i].timestamp_s);
    EXPECT_TRUE(camera.arrived().empty());
}

TEST(CameraThread, TheWheelsTellTheMotionThatTheImagesDoNotShow) {
    for (const double v_mps : {0.5, -0.5}) {
        const SteadyClock clock;
        std::vector<pipeline::Step> steps;
        // So slow that no image waits for the step of the one before, not even with the thread sanitizer.
        CameraThread camera(images(8, 4.0), clock,
                            [&steps](const Field&, const pipeline::Step& step) { steps.push_back(step); });
        double next_s = clock.now_s();
        while (camera.end().empty()) {
            if (clock.now_s() < next_s) continue;
            camera.odometry({next_s, {v_mps * next_s, 0.0, 0.0}, {v_mps, 0.0}});
            next_s += 0.02;
        }
        ASSERT_EQ(steps.size(), 8U);
        EXPECT_NE(steps.back().status, FieldStatus::Ok);
        EXPECT_EQ(steps.back().motion.forward_source, MotionSource::Wheels);
        EXPECT_NEAR(steps.back().v_mps, v_mps, 0.01);
    }
}

TEST(CameraThread, WhatIsThrownInTheThreadEndsTheFeedAndIsTold) {
    const SteadyClock clock;
    CameraThread camera(three_images(), clock, [](const Field&, const pipeline::Step&) {
        throw std::runtime_error("no memory left");
    });
    EXPECT_EQ(end_of(camera), "the camera's thread failed: no memory left");
}

TEST(CameraThread, GoesAtOnceThoughTheRecordingIsLong) {
    io::ProducerSettings settings = three_images();
    settings.rate_hz = 0.001;  // the second image comes after a quarter of an hour
    const SteadyClock clock;
    const double began_s = clock.now_s();
    { const CameraThread camera(settings, clock, {}); }
    EXPECT_LT(clock.now_s() - began_s, 60.0);
}

}  // namespace
}  // namespace flownav::drive
