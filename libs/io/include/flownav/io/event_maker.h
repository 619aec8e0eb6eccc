#pragma once
#include <mrpt/math/TPose3D.h>
#include <mrpt/obs/CObservationImage.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/field.h"
#include "flownav/io/field_splitter.h"

namespace flownav::io {

/// A pose of the robot's axis, projected on the ground where the source says so.
struct PoseSample {
    enum class Source { Odometry, GroundTruth };
    Source source = Source::Odometry;
    double timestamp_s = 0.0;
    mrpt::math::TPose3D pose;
};

/// A field, or a pose, in the order in which they were observed.
using SensorEvent = std::variant<Field, PoseSample>;

/// What was read, and what was left out and why.
struct InputCounts {
    std::uint64_t objects = 0;                          ///< of a rawlog; 0 where there is none
    std::uint64_t images = 0;                           ///< of the camera's label
    std::uint64_t fields = 0;                           ///< handed out
    std::uint64_t odometry = 0;                         ///< handed out
    std::uint64_t ground_truth = 0;                     ///< handed out
    std::uint64_t ignored = 0;                          ///< observations of other labels and classes
    std::map<std::string, std::uint64_t> rejected;      ///< by reason, see EventMaker
    std::map<std::string, std::uint64_t> warnings;      ///< used all the same: image_size_changed, ...
    std::map<std::string, std::uint64_t> observations;  ///< everything read, by "class label"
};

/// Why `source`, read to its clean end, gave no field at all, and what to do.
std::string why_no_field(const InputCounts& counts, const std::string& source,
                         const std::string& camera_label);

/// Turns observations into fields and poses: applies the calibration (ini over recording), converts colour
/// to grey (also the intensity image of a CObservation3DRangeScan of the camera's label), splits woven
/// frames, rejects what cannot be used and counts why: time_invalid, time_repeated, time_backwards,
/// image_missing (external file), image_unreadable, image_empty, image_not_8bit; for poses odometry_... and
/// ground_truth_... time_invalid, time_repeated, time_backwards and not_finite. Fields of unaltered grey
/// images are views of the observation; nothing is copied. Times rise strictly within each kind of event.
class EventMaker {
  public:
    explicit EventMaker(const config::CameraConfig& camera) : camera_(camera), splitter_(camera.interlaced) {}

    /// Takes an observation in; what it gives, if anything, waits for next(). Relative names of external
    /// images refer to `images_directory`. Throws ConfigError: an image without calibration (names the keys
    /// to set), or a camera pose that cannot be used (height not positive, looking up, roll or yaw over 10
    /// degrees).
    void consume(const mrpt::obs::CObservation::Ptr& observation,
                 const std::filesystem::path& images_directory);

    /// After the last observation: the second field of a last woven frame.
    void finish() { hand_out(splitter_.finish()); }

    /// What is ready, in its order; nothing: more observations are needed.
    std::optional<SensorEvent> next();

    /// Tells the counts how many objects of a rawlog were read so far.
    void count_objects(std::uint64_t objects) { counts_.objects = objects; }

    const InputCounts& counts() const { return counts_; }

  private:
    void consume_image(const mrpt::obs::CObservationImage::Ptr& image,
                       const std::filesystem::path& images_directory);
    void consume_pose(const PoseSample& sample, const std::string& kind);
    bool accept_time(const std::string& kind, double timestamp_s);
    void hand_out(const std::vector<Field>& fields);
    void note_changes(const Field& frame, const mrpt::obs::CObservationImage& image);

    config::CameraConfig camera_;
    InputCounts counts_;
    std::map<std::string, double> last_time_s_;  ///< of each kind of event
    std::optional<CameraModel> last_camera_;
    std::deque<SensorEvent> waiting_;
    FieldSplitter splitter_;
};

}  // namespace flownav::io
