#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>

namespace flownav::io {

/// An image of a video.
struct VideoImage {
    cv::Mat grey;                  ///< turned as the rotation tag says
    std::optional<double> time_s;  ///< stamp of the container; empty when it has none
    bool interlaced = false;       ///< flagged as two woven fields
    bool top_field_first = false;
};

/// What the container tells about its video.
struct VideoFacts {
    std::optional<double> rate_hz;  ///< images a second, 1 .. 1000; empty: not told
    bool has_times = false;         ///< false for raw streams, whose stamps are made up, and without a rate
    std::uint64_t images = 0;       ///< as the header says; 0: not told
    int turn_deg = 0;               ///< clockwise turn to see it upright: 0, 90, 180 or 270
    bool odd_rotation = false;  ///< the rotation tag mirrors, or turns by another angle; it is not followed
};

/// Decodes a video file with FFmpeg's libraries.
class VideoDecoder {
  public:
    /// Throws InputError: no such file, not a file, or no video that can be read.
    explicit VideoDecoder(const std::filesystem::path& file);
    ~VideoDecoder();
    VideoDecoder(const VideoDecoder&) = delete;
    VideoDecoder& operator=(const VideoDecoder&) = delete;

    /// Next image, to the last one; empty at the end.
    std::optional<VideoImage> next();

    const VideoFacts& facts() const;

    /// After the end: tells that the file ends before its header says so; empty when it does not.
    std::string cut_short() const;

    /// Compressed images that could not be decoded so far.
    std::uint64_t damaged() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace flownav::io
