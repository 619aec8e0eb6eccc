#include "flownav/io/picture_file.h"

#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace flownav::io {
namespace {

using Bytes = std::vector<char>;

unsigned byte_at(const Bytes& bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]);
}

/// Place of the next marker of a JPEG in its compressed data: 0xFF and neither a stuffed zero nor a restart.
std::size_t next_marker(const Bytes& bytes, std::size_t at) {
    for (; at + 1 < bytes.size(); ++at) {
        const unsigned after = byte_at(bytes, at + 1);
        const bool restart = after >= 0xD0 && after <= 0xD7;
        if (byte_at(bytes, at) == 0xFF && after != 0 && after != 0xFF && !restart) return at;
    }
    return bytes.size();
}

/// True for a JPEG without its end marker, which decoders fill up with grey.
bool jpeg_cut_short(const Bytes& bytes) {
    if (bytes.size() < 4 || byte_at(bytes, 0) != 0xFF || byte_at(bytes, 1) != 0xD8) return false;
    std::size_t at = 2;
    while (at + 3 < bytes.size()) {
        const unsigned marker = byte_at(bytes, at + 1);
        if (byte_at(bytes, at) != 0xFF || marker == 0xFF) {
            ++at;  // fill bytes
        } else if (marker == 0xD9) {
            return false;
        } else {
            at += 2 + 256 * byte_at(bytes, at + 2) + byte_at(bytes, at + 3);
            if (marker == 0xDA) at = next_marker(bytes, at);
        }
    }
    return !(at + 1 < bytes.size() && byte_at(bytes, at) == 0xFF && byte_at(bytes, at + 1) == 0xD9);
}

}  // namespace

cv::Mat read_picture(const std::filesystem::path& file, int flags) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return {};
    std::vector<char> bytes(std::filesystem::file_size(file, error));
    std::ifstream stream(file, std::ios::binary);
    if (error || bytes.empty() || !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        return {};
    if (jpeg_cut_short(bytes)) return {};
    try {
        return cv::imdecode(cv::Mat(1, static_cast<int>(bytes.size()), CV_8UC1, bytes.data()), flags);
    } catch (const cv::Exception&) {
        return {};
    }
}

}  // namespace flownav::io
