#pragma once
#include <filesystem>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/io/image_sequence.h"

namespace flownav::io {

/// How images without times of their own get them: from a file, else at a constant rate.
struct FrameTimes {
    std::filesystem::path file;     ///< empty: look for times.txt and log.csv in and beside the folder
    std::optional<double> rate_hz;  ///< set: no file is looked for
    double default_rate_hz = 25.0;
};

/// Times in seconds, one a row, for the images in the order of their names: the column named timestamp_s,
/// timestamp, time_s or time of the header, or the first column when there is no header. Columns are
/// separated by commas, semicolons or blanks. Throws InputError.
std::vector<double> read_times_file(const std::filesystem::path& file);

/// The pictures (png, jpg, bmp, pgm, tif) of a folder in the order of their names; numbers in names count as
/// numbers. Colour becomes grey.
class ImageFolder : public ImageSequence {
  public:
    ImageFolder(const std::filesystem::path& directory, config::CameraConfig camera, const FrameTimes& times);

    std::optional<SequenceFrame> next() override;
    std::size_t size() const override { return images_.size(); }

    /// Where the times come from, for people.
    const std::string& times_source() const { return times_source_; }

  private:
    std::vector<std::filesystem::path> images_;
    std::vector<double> times_s_;
    std::string times_source_;
    config::CameraConfig camera_;
    std::size_t at_ = 0;
};

}  // namespace flownav::io
