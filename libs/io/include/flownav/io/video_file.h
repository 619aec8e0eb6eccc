#pragma once
#include <filesystem>
#include <memory>

#include "flownav/config/config.h"
#include "flownav/io/image_sequence.h"

namespace flownav::io {

/// Images of a video, converted to grey. Image i has the time i / rate_hz; without `rate_hz` the video's own
/// rate is used. The constructor throws InputError.
class VideoFile : public ImageSequence {
  public:
    VideoFile(const std::filesystem::path& file, config::CameraConfig camera, std::optional<double> rate_hz);
    ~VideoFile() override;

    std::optional<SequenceFrame> next() override;
    std::size_t size() const override;

    double rate_hz() const { return rate_hz_; }

  private:
    struct Capture;
    std::unique_ptr<Capture> capture_;
    config::CameraConfig camera_;
    double rate_hz_ = 0.0;
    std::size_t at_ = 0;
};

}  // namespace flownav::io
