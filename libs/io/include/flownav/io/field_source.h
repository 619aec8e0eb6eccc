#pragma once
#include <exception>
#include <optional>

#include "flownav/io/event_maker.h"
#include "flownav/io/rawlog_reader.h"
#include "flownav/io/readings_first.h"

namespace flownav::io {

/// A field, a pose or a reading of a gyro of a rawlog.
using ReplayEvent = SensorEvent;

/// Fields, poses and gyro readings of a rawlog, converted by an EventMaker, in the order of the file; but a
/// field comes after the first reading of wheels and gyro that is not before it, see ReadingsFirst.
class FieldSource {
  public:
    FieldSource(RawlogReader& reader, const config::CameraConfig& camera,
                const config::InputConfig& input = {})
        : reader_(reader), maker_(camera, input) {}

    /// Continues in the state of another source whose reader stood where `reader` stands now; `like` may have
    /// reached its end.
    FieldSource(RawlogReader& reader, const FieldSource& like)
        : reader_(reader), maker_(like.maker_), order_(like.order_) {}

    /// Next event; empty at the end of the rawlog. Times rise strictly within each kind of event. Throws
    /// ConfigError: an image without calibration (names the keys to set), or an unusable camera pose (height
    /// not positive, looking up, roll or yaw over 10 degrees).
    std::optional<ReplayEvent> next();

    const InputCounts& counts() const { return maker_.counts(); }

  private:
    void advance();

    RawlogReader& reader_;
    EventMaker maker_;
    ReadingsFirst order_;
    bool finished_ = false;
    std::exception_ptr error_;  ///< of an observation that cannot be used, thrown after the events before it
};

}  // namespace flownav::io
