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
#include "flownav/core/readings.h"
#include "flownav/io/field_splitter.h"

namespace flownav::io {

/// Pose of the robot's axis, as recorded.
struct PoseSample {
    enum class Source { Odometry, GroundTruth };
    Source source = Source::Odometry;
    double timestamp_s = 0.0;
    mrpt::math::TPose3D pose;
};

/// A field, a pose, or a reading of a gyro.
using SensorEvent = std::variant<Field, PoseSample, GyroRate>;

/// Counts of observations read, used and rejected.
struct InputCounts {
    std::uint64_t objects = 0;                          ///< objects of a rawlog; 0 for other sources
    std::uint64_t images = 0;                           ///< images with the camera's label
    std::uint64_t fields = 0;                           ///< returned by next()
    std::uint64_t odometry = 0;                         ///< odometry poses used
    std::uint64_t ground_truth = 0;                     ///< ground truth poses used
    std::uint64_t gyro = 0;                             ///< gyro readings used
    std::uint64_t ignored = 0;                          ///< observations of other labels and classes
    std::map<std::string, std::uint64_t> rejected;      ///< by reason, see EventMaker
    std::map<std::string, std::uint64_t> warnings;      ///< used nevertheless: image_size_changed, ...
    std::map<std::string, std::uint64_t> observations;  ///< all observations, by "class label"
};

/// Message why `source`, read to its clean end, gave no field, and which key to set.
std::string why_no_field(const InputCounts& counts, const std::string& source,
                         const std::string& camera_label);

/// Turns observations into fields, poses and gyro readings: applies the calibration (ini over recording),
/// converts colour to grey (also the intensity image of a CObservation3DRangeScan of the camera's label),
/// splits woven frames, rejects unusable observations and counts the reasons: time_invalid, time_repeated,
/// time_backwards, image_missing (external file), image_unreadable, image_empty, image_not_8bit; for poses
/// time_invalid, time_repeated, time_backwards and not_finite with the prefix odometry_, ground_truth_ or
/// gyro_. A CObservationIMU with turn rates is a gyro, of the first label that has them; its rate is taken
/// about the robot's upward axis by the sensor's pose. Fields of 8-bit grey images are views that share the
/// observation's pixels. Times rise strictly within each kind of event.
class EventMaker {
  public:
    explicit EventMaker(const config::CameraConfig& camera) : camera_(camera), splitter_(camera.interlaced) {}

    /// Converts an observation; next() returns the resulting events. Relative names of external images refer
    /// to `images_directory`. Throws ConfigError: an image without calibration (names the keys to set), or an
    /// unusable camera pose (height not positive, looking up, roll or yaw over 10 degrees).
    void consume(const mrpt::obs::CObservation::Ptr& observation,
                 const std::filesystem::path& images_directory);

    /// Must be called after the last observation; completes the second field of a last woven frame.
    void finish() { hand_out(splitter_.finish()); }

    /// Next event in the order of observation; empty when more observations are needed.
    std::optional<SensorEvent> next();

    /// Sets the number of rawlog objects read so far.
    void count_objects(std::uint64_t objects) { counts_.objects = objects; }

    const InputCounts& counts() const { return counts_; }

  private:
    void consume_image(const mrpt::obs::CObservationImage::Ptr& image,
                       const std::filesystem::path& images_directory);
    void consume_pose(const PoseSample& sample, const std::string& kind);
    void consume_gyro(const GyroRate& reading);
    bool is_gyro(const mrpt::obs::CObservation& observation);
    bool accept_time(const std::string& kind, double timestamp_s);
    void hand_out(const std::vector<Field>& fields);
    void note_changes(const Field& frame, const mrpt::obs::CObservationImage& image);

    config::CameraConfig camera_;
    InputCounts counts_;
    std::map<std::string, double> last_time_s_;  ///< time of the last accepted event of each kind
    std::optional<std::string> gyro_label_;      ///< of the first gyro
    std::optional<CameraModel> last_camera_;
    std::deque<SensorEvent> waiting_;
    FieldSplitter splitter_;
};

}  // namespace flownav::io
