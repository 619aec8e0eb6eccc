#pragma once
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace flownav::testing {

/// How write_timed_video() encodes.
struct VideoSample {
    const char* format = "mp4";   ///< of FFmpeg's writers: mp4, avi, mjpeg, matroska ...
    const char* codec = "mpeg4";  ///< mpeg4, mjpeg, mpeg2video ...
    std::vector<int> stamps_ms;   ///< of the images, rising; all equal: one tick of the rate apart
    int rate_hz = 0;              ///< that the stamps are rounded to; 0: milliseconds
    int b_frames = 0;
    int rotation_deg = 0;  ///< tag: clockwise turn to see the images upright
    bool top_field_first = false;
};

/// Writes grey images as a video; false when this FFmpeg cannot.
bool write_timed_video(const std::filesystem::path& file, const std::vector<cv::Mat>& images,
                       const VideoSample& sample);

}  // namespace flownav::testing
