#pragma once
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

namespace flownav::io {

/// What libflownav-video.so gives to a VideoOutputFile: OpenCV's encoder, one of them for one video.
class VideoEncoder {
  public:
    virtual ~VideoEncoder() = default;
    /// H.264 in MP4; width and height even. False when OpenCV cannot do that.
    virtual bool open(const std::string& file, double rate_hz, const cv::Size& size) = 0;
    virtual void write(const cv::Mat& picture) = 0;
    virtual void close() = 0;
    /// How many pictures a reader of that file finds; 0 when it is no video.
    virtual std::uint64_t pictures_in(const std::string& file) const = 0;
};

/// The module's only symbol.
using MakeVideoEncoder = VideoEncoder*();
constexpr const char* make_video_encoder_symbol = "flownav_make_video_encoder";

}  // namespace flownav::io
