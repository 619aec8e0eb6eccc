#pragma once
#include <mrpt/math/TPose3D.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>

#include "flownav/core/field.h"
#include "flownav/replay/rawlog_reader.h"
#include "flownav/sensor/config.h"

namespace flownav {

/// A pose of the robot's axis, projected on the ground where the source says so.
struct PoseSample {
    enum class Source { Odometry, GroundTruth };
    Source source = Source::Odometry;
    double timestamp_s = 0.0;
    mrpt::math::TPose3D pose;
};

/// A field, or a pose, in the order of the file.
using ReplayEvent = std::variant<Field, PoseSample>;

/// What was read, and what was left out and why.
struct InputCounts {
    std::uint64_t objects = 0;
    std::uint64_t images = 0;        ///< of the camera's label
    std::uint64_t fields = 0;        ///< handed out
    std::uint64_t odometry = 0;
    std::uint64_t ground_truth = 0;
    std::uint64_t ignored = 0;       ///< observations of other labels and classes
    std::map<std::string, std::uint64_t> rejected;  ///< by reason: time_backwards, time_repeated, image_missing, ...
};

/// Turns the observations of a rawlog into fields and poses: applies the calibration (ini over recording),
/// converts colour to grey, splits woven frames, rejects what cannot be used and counts why.
class FieldSource {
  public:
    FieldSource(RawlogReader& reader, const CameraConfig& camera);

    /// The next event, or nothing at the end of the rawlog.
    /// Throws ConfigError: an image without calibration (names the keys to set), or a camera pose that cannot
    /// be used (height not positive, looking up, roll or yaw over 10 degrees).
    std::optional<ReplayEvent> next();

    const InputCounts& counts() const { return counts_; }

  private:
    RawlogReader& reader_;
    CameraConfig camera_;
    InputCounts counts_;
};

}  // namespace flownav
