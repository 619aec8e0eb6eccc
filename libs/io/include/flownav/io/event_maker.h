#pragma once
#include <mrpt/obs/CObservationImage.h>

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "flownav/config/config.h"
#include "flownav/core/field.h"
#include "flownav/io/event_times.h"
#include "flownav/io/field_splitter.h"
#include "flownav/io/sensor_event.h"

namespace flownav::io {

/// Message why `source`, read to its clean end, gave no field, and which key to set.
std::string why_no_field(const InputCounts& counts, const std::string& source,
                         const std::string& camera_label);

/// Turns observations into fields, poses and gyro readings: applies the calibration (ini over recording),
/// converts colour to grey (also the intensity image of a CObservation3DRangeScan and the left image of a
/// CObservationStereoImages of the camera's label), turns and mirrors images as the ini says, puts the times
/// right (EventTimes), splits woven frames, rejects unusable observations and counts the reasons:
/// image_missing (external file), image_unreadable, image_empty, image_not_8bit, those of EventTimes, and for
/// poses and gyro not_finite with the prefix odometry_, ground_truth_ or gyro_. A CObservationIMU with turn
/// rates is a gyro, of the first label that has them; its rate is taken
/// about the robot's upward axis by the sensor's pose. Fields of 8-bit grey images are views that share the
/// observation's pixels. Times rise strictly within each kind of event.
class EventMaker {
  public:
    explicit EventMaker(const config::CameraConfig& camera, config::InputConfig input = {},
                        EventTimes::Mode mode = EventTimes::Mode::Recording)
        : camera_(camera), input_(std::move(input)), times_(mode), splitter_(camera.interlaced) {}

    /// Converts an observation; next() returns the resulting events. Relative names of external images refer
    /// to `images_directory`. Throws ConfigError: an image without calibration (names the keys to set), or an
    /// unusable camera pose (height not positive, looking up, roll or yaw over 10 degrees).
    void consume(const mrpt::obs::CObservation::Ptr& observation,
                 const std::filesystem::path& images_directory);

    /// Must be called after the last observation; hands out what was held back.
    void finish();

    /// Next event in the order of observation; empty when more observations are needed.
    std::optional<SensorEvent> next();

    /// Sets the number of rawlog objects read so far.
    void count_objects(std::uint64_t objects) { counts_.objects = objects; }

    const InputCounts& counts() const { return counts_; }

  private:
    void consume_image(const mrpt::obs::CObservationImage::Ptr& image,
                       const std::filesystem::path& images_directory);
    void consume_pose(PoseSample sample);
    void consume_gyro(const GyroRate& reading);
    bool is_gyro(const mrpt::obs::CObservation& observation);
    void drain();
    void hand_out(const std::vector<Field>& fields);
    void note_changes(const CameraModel& now);

    config::CameraConfig camera_;
    config::InputConfig input_;
    InputCounts counts_;
    EventTimes times_;
    std::optional<std::string> gyro_label_;  ///< of the first gyro
    std::optional<CameraModel> last_camera_;
    std::deque<SensorEvent> waiting_;
    FieldSplitter splitter_;
};

}  // namespace flownav::io
