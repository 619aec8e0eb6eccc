#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "flownav/io/live_fields.h"

/// Small sources of images for the tests of the producer.
namespace flownav::testing {

/// A folder of its own for the running test, emptied first.
std::filesystem::path producer_folder();

/// Settings from the lines of a section [FLOW]; throws what read_producer_settings() throws.
io::ProducerSettings producer_settings(const std::string& lines);

/// Enough of a calibration for any image.
extern const std::string calibration_lines;

/// 64 x 48 images of noise, each different.
std::vector<cv::Mat> noise_images(int count);

/// A lossless grey video.
void write_video(const std::filesystem::path& file, const std::vector<cv::Mat>& images, double rate_hz);

/// image_000.png and so on.
void write_images(const std::filesystem::path& folder, const std::vector<cv::Mat>& images);

/// All fields of a source, until its end.
std::vector<Field> all_fields(io::LiveFields& live);

/// What LiveFields says about a source that it cannot open.
std::string reason_not_to_open(const std::string& lines);

/// Whether a message holds all these words; an assertion prints it if not.
template <class... Words>
::testing::AssertionResult says(const std::string& message, const Words&... words) {
    const bool all = ((message.find(words) != std::string::npos) && ...);
    return (all ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << '"' << message << '"';
}

}  // namespace flownav::testing
