#pragma once
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace flownav::report {

/// A picture inside a page: the bytes of a file ("image/jpeg") as text, for src='...'.
std::string data_uri(const std::string& type, const std::vector<std::uint8_t>& bytes);

/// The same of a picture, as PNG.
std::string png_uri(const cv::Mat& picture);

}  // namespace flownav::report
