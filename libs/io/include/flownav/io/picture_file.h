#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace flownav::io {

/// A picture as cv::imread() gives it with these flags; empty, and without OpenCV's own warnings, when the
/// file is missing or no picture.
cv::Mat read_picture(const std::filesystem::path& file, int flags);

}  // namespace flownav::io
