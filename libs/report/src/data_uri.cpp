#include "flownav/report/data_uri.h"

#include <mrpt/system/string_utils.h>

#include <opencv2/imgcodecs.hpp>

namespace flownav::report {

std::string data_uri(const std::string& type, const std::vector<std::uint8_t>& bytes) {
    std::string text;
    mrpt::system::encodeBase64(bytes, text);
    // Some versions break the text into lines.
    text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == '\r' || c == '\n'; }),
               text.end());
    return "data:" + type + ";base64," + text;
}

std::string png_uri(const cv::Mat& picture) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".png", picture, bytes, {cv::IMWRITE_PNG_COMPRESSION, 9});
    return data_uri("image/png", bytes);
}

}  // namespace flownav::report
