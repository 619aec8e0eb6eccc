#pragma once
#include <mrpt/math/TPose3D.h>
#include <mrpt/obs/CObservationImage.h>

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "flownav/core/field.h"
#include "flownav/replay/field_splitter.h"
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
    std::uint64_t images = 0;                           ///< of the camera's label
    std::uint64_t fields = 0;                           ///< handed out
    std::uint64_t odometry = 0;                         ///< handed out
    std::uint64_t ground_truth = 0;                     ///< handed out
    std::uint64_t ignored = 0;                          ///< observations of other labels and classes
    std::map<std::string, std::uint64_t> rejected;      ///< by reason, see FieldSource
    std::map<std::string, std::uint64_t> warnings;      ///< used all the same: image_size_changed, ...
    std::map<std::string, std::uint64_t> observations;  ///< everything read, by "class label"
};

/// Turns the observations of a rawlog into fields and poses: applies the calibration (ini over recording),
/// converts colour to grey (also the intensity image of a CObservation3DRangeScan of the camera's label),
/// splits woven frames, rejects what cannot be used and counts why: time_invalid, time_repeated,
/// time_backwards, image_missing (external file), image_unreadable, image_empty, image_not_8bit; for poses
/// odometry_... and ground_truth_... time_invalid, time_repeated, time_backwards and not_finite. Fields of
/// unaltered grey images are views of the recording; nothing is copied.
class FieldSource {
  public:
    FieldSource(RawlogReader& reader, const CameraConfig& camera);

    /// The next event, or nothing at the end of the rawlog. Times rise strictly within each kind of event.
    /// Throws ConfigError: an image without calibration (names the keys to set), or a camera pose that cannot
    /// be used (height not positive, looking up, roll or yaw over 10 degrees).
    std::optional<ReplayEvent> next();

    const InputCounts& counts() const { return counts_; }

  private:
    void consume(const mrpt::obs::CObservation::Ptr& observation);
    void consume_image(const mrpt::obs::CObservationImage::Ptr& image);
    void consume_pose(const PoseSample& sample, const std::string& kind);
    bool accept_time(const std::string& kind, double timestamp_s);
    void hand_out(const std::vector<Field>& fields);
    void note_changes(const Field& frame, const mrpt::obs::CObservationImage& image);

    RawlogReader& reader_;
    CameraConfig camera_;
    InputCounts counts_;
    std::map<std::string, double> last_time_s_;  ///< of each kind of event
    std::optional<CameraModel> last_camera_;
    std::deque<ReplayEvent> waiting_;
    FieldSplitter splitter_;
};

}  // namespace flownav
