#pragma once
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace flownav::io {

/// OpenCV's video encoder, loaded from libflownav-video.so by VideoOutputFile; one object per video.
class VideoEncoder {
  public:
    virtual ~VideoEncoder() = default;
    /// Opens `file` for H.264 in MP4; width and height of `size` must be even. False when OpenCV cannot
    /// encode it.
    virtual bool open(const std::string& file, double rate_hz, const cv::Size& size) = 0;
    virtual void write(const cv::Mat& picture) = 0;
    virtual void close() = 0;
    /// Number of pictures that `file` holds; 0 when it is not a video.
    virtual std::uint64_t pictures_in(const std::string& file) const = 0;
};

/// Type and name of the module's only symbol.
using MakeVideoEncoder = VideoEncoder*();
constexpr const char* make_video_encoder_symbol = "flownav_make_video_encoder";

}  // namespace flownav::io
