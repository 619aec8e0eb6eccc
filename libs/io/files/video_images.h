#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/field.h"
#include "video_decoder.h"

namespace flownav::io {

/// Images of a video without camera. The first one has the time 0, the others the stamps of the container
/// after it, or, with `rate_hz` and for containers without stamps, a constant rate. Times rise: images that
/// are not later than the one before are left out.
class VideoImages {
  public:
    /// `rate_option` names what sets the rate, for messages. Throws InputError.
    VideoImages(const std::filesystem::path& file, std::optional<double> rate_hz, const char* rate_option);

    /// Next image; empty at the end, when the notes and problems are complete.
    std::optional<Field> next();

    /// Number of images that the header tells; 0: unknown.
    std::size_t size() const { return static_cast<std::size_t>(decoder_.facts().images); }

    /// Images a second that the video tells or the caller asked for; 0: only the stamps tell.
    double rate_hz() const { return rate_hz_; }

    /// Tells of the order of woven fields when the images are flagged as such and `configured` differs.
    std::string advice(config::Interlaced configured) const;

    const std::vector<std::string>& notes() const { return notes_; }
    const std::vector<std::string>& problems() const { return problems_; }

  private:
    std::optional<double> time_of(const VideoImage& image);
    void finish();

    std::filesystem::path file_;
    VideoDecoder decoder_;
    bool constant_rate_ = false;
    double rate_hz_ = 0.0;
    std::size_t images_ = 0;
    std::size_t unstamped_ = 0, not_rising_ = 0, other_size_ = 0;
    std::size_t interlaced_ = 0, top_first_ = 0;
    std::optional<double> first_s_, last_s_;
    double period_s_ = 0.0;
    int width_px_ = 0, height_px_ = 0;
    bool finished_ = false;
    std::vector<std::string> notes_, problems_;
};

}  // namespace flownav::io
