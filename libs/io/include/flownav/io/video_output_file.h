#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>

namespace flownav::io {

class VideoEncoder;

/// A video (H.264 in MP4) whose failures are told. FFmpeg's libraries are loaded, with libflownav-video.so,
/// when the first picture is written: a program that writes none needs neither their memory nor their time.
class VideoOutputFile {
  public:
    /// Throws OutputError when `file` cannot be written.
    VideoOutputFile(std::filesystem::path file, double rate_hz);
    ~VideoOutputFile();
    VideoOutputFile(const VideoOutputFile&) = delete;
    VideoOutputFile& operator=(const VideoOutputFile&) = delete;

    /// Three channels, all pictures of the same size, width and height even. Throws OutputError when there is
    /// no encoder.
    void write(const cv::Mat& picture);

    /// Completes the file. Throws OutputError when it did not become a whole video, as on a full disk.
    void close();

    /// Pictures written so far.
    std::uint64_t pictures() const { return pictures_; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    double rate_hz_;
    std::unique_ptr<VideoEncoder> encoder_;
    std::uint64_t pictures_ = 0;
};

}  // namespace flownav::io
