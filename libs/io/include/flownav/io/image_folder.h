#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/io/image_sequence.h"
#include "flownav/io/time_unit.h"

namespace flownav::io {

/// Source of the time stamps of images: a file, their names, else a constant rate.
struct FrameTimes {
    std::filesystem::path file;     ///< empty: a list in the folder or its parent
    std::optional<double> rate_hz;  ///< when set, no file is searched for
    double default_rate_hz = 25.0;
    std::optional<TimeUnit> unit =
        std::nullopt;  ///< of the times in the file or in the names; empty: recognised
};

struct ImageSchedule;
class GreyPictures;

/// Pictures (png, jpg, bmp, pgm, ppm, tif, webp) of a folder. Colour is converted to grey, deep grey to 8
/// bits. A list of times has one time a row: matched by a column of names (timestamp_s,filename) or numbers,
/// by the times in the names of the images (1403636579763555584.png), by the numbers in their names when
/// these have gaps, else by order; what cannot be matched without doubt is refused. A list may have the
/// readings of a gyro (gyro_z_degps or gyro_z_radps, > 0 to the left: the mean rate from the time of its row
/// to that of the next, dated half-way).
class ImageFolder : public ImageSequence {
  public:
    ImageFolder(const std::filesystem::path& directory, config::CameraConfig camera, const FrameTimes& times);
    ~ImageFolder() override;

    std::optional<SequenceFrame> next() override;
    std::size_t size() const override;
    std::vector<GyroRate> gyro() const override;

    /// Description of the source of the times, for messages.
    const std::string& times_source() const;

  private:
    std::unique_ptr<ImageSchedule> schedule_;
    std::unique_ptr<GreyPictures> pictures_;
    config::CameraConfig camera_;
    std::size_t at_ = 0;
};

}  // namespace flownav::io
