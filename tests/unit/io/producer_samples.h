#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "flownav/io/live_fields.h"

/// Small sources of images for the tests of the producer.
namespace flownav::testing {

/// Creates an empty folder for the running test.
std::filesystem::path producer_folder();

/// Reads settings from the lines of a section [FLOW]; throws as read_producer_settings().
io::ProducerSettings producer_settings(const std::string& lines);

/// A calibration valid for any image.
extern const std::string calibration_lines;

/// 64 x 48 images of noise, each different.
std::vector<cv::Mat> noise_images(int count);

/// Writes a lossless grey video.
void write_video(const std::filesystem::path& file, const std::vector<cv::Mat>& images, double rate_hz);

/// Writes image_000.png and so on.
void write_images(const std::filesystem::path& folder, const std::vector<cv::Mat>& images);

/// Reads all fields of a source.
std::vector<Field> all_fields(io::LiveFields& live);

/// Error message of LiveFields for a source that cannot be opened.
std::string reason_not_to_open(const std::string& lines);

/// Asserts that a message holds all these words.
template <class... Words>
::testing::AssertionResult says(const std::string& message, const Words&... words) {
    const bool all = ((message.find(words) != std::string::npos) && ...);
    return (all ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << '"' << message << '"';
}

}  // namespace flownav::testing
