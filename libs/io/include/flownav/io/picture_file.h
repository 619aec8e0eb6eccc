#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace flownav::io {

/// Reads a picture as cv::imread() with these flags, but without OpenCV's warnings. Empty when the file is
/// missing, not a picture or cut short.
cv::Mat read_picture(const std::filesystem::path& file, int flags);

}  // namespace flownav::io
