#pragma once
#include <filesystem>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/io/image_sequence.h"

namespace flownav::io {

/// Source of the time stamps of images: a file, else a constant rate.
struct FrameTimes {
    std::filesystem::path file;     ///< empty: times.txt or log.csv in the folder or its parent
    std::optional<double> rate_hz;  ///< when set, no file is searched for
    double default_rate_hz = 25.0;
};

/// Reads times in seconds, one per row, for the images in the order of their names: from the column named
/// timestamp_s, timestamp, time_s or time, or from the first column when there is no header. Columns are
/// separated by commas, semicolons or blanks. Throws InputError, also when the times do not rise.
std::vector<double> read_times_file(const std::filesystem::path& file);

/// Reads gyro readings from the column gyro_z_degps or gyro_z_radps (> 0 to the left) of a file with times:
/// the mean rate from the time of its row to that of the next, dated half-way. Empty when there is no such
/// column. Throws InputError.
std::vector<GyroRate> read_gyro_file(const std::filesystem::path& file);

/// Pictures (png, jpg, bmp, pgm, tif) of a folder in the order of their names, with digits compared as
/// numbers. Colour is converted to grey. A file with times may have the readings of a gyro as well.
class ImageFolder : public ImageSequence {
  public:
    ImageFolder(const std::filesystem::path& directory, config::CameraConfig camera, const FrameTimes& times);

    std::optional<SequenceFrame> next() override;
    std::size_t size() const override { return images_.size(); }
    std::vector<GyroRate> gyro() const override { return gyro_; }

    /// Description of the source of the times, for messages.
    const std::string& times_source() const { return times_source_; }

  private:
    std::vector<std::filesystem::path> images_;
    std::vector<double> times_s_;
    std::vector<GyroRate> gyro_;
    std::string times_source_;
    config::CameraConfig camera_;
    std::size_t at_ = 0;
};

}  // namespace flownav::io
