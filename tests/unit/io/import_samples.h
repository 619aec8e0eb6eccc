#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <initializer_list>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/io/image_sequence.h"

namespace flownav::testing {

/// A picture of 64 x 48 whose line v has the grey value 3 v + offset.
cv::Mat sample_picture(int offset);

/// Writes sample_picture(offset), and the folders above it.
void write_sample_picture(const std::filesystem::path& file, int offset);

/// A camera for these pictures.
config::CameraConfig sample_camera();

/// Times of all images of a sequence, read to its end.
std::vector<double> times_of(io::ImageSequence& sequence);

/// Expects these times, to the microsecond.
void expect_times(const std::vector<double>& times_s, const std::vector<double>& expected_s);

/// True when some of the sentences holds all parts.
bool some_says(const std::vector<std::string>& sentences, std::initializer_list<const char*> parts);

/// Expects that all parts are in the message.
void expect_parts(const std::string& message, std::initializer_list<const char*> parts);

}  // namespace flownav::testing
