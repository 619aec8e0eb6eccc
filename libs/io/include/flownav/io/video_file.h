#pragma once
#include <filesystem>
#include <memory>

#include "flownav/config/config.h"
#include "flownav/io/image_sequence.h"

namespace flownav::io {

class VideoImages;

/// Images of a video, converted to grey and turned as the video's rotation tag says. They have the stamps of
/// the container, from 0 on; with `rate_hz` image i has the time i / rate_hz. The constructor throws
/// InputError, also when the video has no stamps and no rate is given.
class VideoFile : public ImageSequence {
  public:
    VideoFile(const std::filesystem::path& file, config::CameraConfig camera, std::optional<double> rate_hz);
    ~VideoFile() override;

    std::optional<SequenceFrame> next() override;
    std::size_t size() const override;

  private:
    std::unique_ptr<VideoImages> images_;
    config::CameraConfig camera_;
    bool told_ = false;  ///< the notes and problems have been taken over
};

}  // namespace flownav::io
