#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "flownav/config/config.h"
#include "flownav/io/image_sequence.h"

namespace flownav::io {

struct RecordingOptions {
    std::filesystem::path output;
    std::string camera_label = "CAMERA1";
    config::Interlaced interlaced = config::Interlaced::None;  ///< split woven frames into fields
    std::function<void(double share, std::uint64_t fields)> progress;
};

struct RecordingCounts {
    std::uint64_t frames = 0;
    std::uint64_t fields = 0;
    std::uint64_t poses = 0;
    std::uint64_t gyro = 0;
};

/// Writes a sequence as a gz rawlog of standard observations: every image with its calibration and camera
/// pose, GROUND_TRUTH for every pose and IMU for every reading of a gyro. The file gets its name when it is
/// complete and is removed on failure. Throws OutputError, and InputError when no image can be read.
RecordingCounts write_recording(ImageSequence& sequence, const RecordingOptions& options);

}  // namespace flownav::io
