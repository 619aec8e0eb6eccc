#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "flownav/core/readings.h"
#include "flownav/io/image_folder.h"

namespace flownav::io {

struct TimedImage {
    std::filesystem::path file;
    double time_s = 0.0;
};

/// Images of a folder in the order of their times.
struct ImageSchedule {
    std::vector<TimedImage> images;
    std::vector<GyroRate> gyro;
    std::string source;                 ///< where the times come from
    std::vector<std::string> notes;     ///< what was recognised or mended, one sentence each
    std::vector<std::string> problems;  ///< what is missing, one sentence each
};

/// Gives the images of a folder their times: from a list by name or by number, from their names, or by their
/// number at a constant rate. Throws InputError when the images and the times cannot be matched without
/// doubt.
ImageSchedule schedule_images(const std::filesystem::path& directory,
                              const std::vector<std::filesystem::path>& images, const FrameTimes& times);

}  // namespace flownav::io
