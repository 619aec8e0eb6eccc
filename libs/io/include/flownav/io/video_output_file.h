#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>

namespace flownav::io {

class VideoEncoder;

/// Video (H.264 in MP4) with checked writing. FFmpeg's libraries are loaded, with libflownav-video.so, when
/// the first picture is written, so that programs that write none do not load them.
class VideoOutputFile {
  public:
    /// Creates `file`. Throws OutputError when it cannot be written.
    VideoOutputFile(std::filesystem::path file, double rate_hz);
    ~VideoOutputFile();
    VideoOutputFile(const VideoOutputFile&) = delete;
    VideoOutputFile& operator=(const VideoOutputFile&) = delete;

    /// Appends a picture of three channels; all pictures have the same size, with even width and height.
    /// Throws OutputError when there is no encoder.
    void write(const cv::Mat& picture);

    /// Completes the file. Throws OutputError when the video is incomplete, as on a full disk.
    void close();

    /// Number of pictures written so far.
    std::uint64_t pictures() const { return pictures_; }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    double rate_hz_;
    std::unique_ptr<VideoEncoder> encoder_;
    std::uint64_t pictures_ = 0;
};

}  // namespace flownav::io
