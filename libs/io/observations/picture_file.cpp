#include "flownav/io/picture_file.h"

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace flownav::io {

cv::Mat read_picture(const std::filesystem::path& file, int flags) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return {};
    std::vector<char> bytes(std::filesystem::file_size(file, error));
    std::ifstream stream(file, std::ios::binary);
    if (error || bytes.empty() || !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        return {};
    try {
        return cv::imdecode(bytes, flags);
    } catch (const cv::Exception&) {
        return {};
    }
}

}  // namespace flownav::io
