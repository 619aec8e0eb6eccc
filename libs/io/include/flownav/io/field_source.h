#pragma once
#include <optional>

#include "flownav/io/event_maker.h"
#include "flownav/io/rawlog_reader.h"

namespace flownav::io {

/// A field, or a pose, in the order of the file.
using ReplayEvent = SensorEvent;

/// The fields and poses of a rawlog, made by an EventMaker.
class FieldSource {
  public:
    FieldSource(RawlogReader& reader, const config::CameraConfig& camera) : reader_(reader), maker_(camera) {}

    /// Goes on like another source whose reader stood where `reader` stands now, also beyond an end.
    FieldSource(RawlogReader& reader, const FieldSource& like) : reader_(reader), maker_(like.maker_) {}

    /// The next event, or nothing at the end of the rawlog. Times rise strictly within each kind of event.
    /// Throws ConfigError: an image without calibration (names the keys to set), or a camera pose that cannot
    /// be used (height not positive, looking up, roll or yaw over 10 degrees).
    std::optional<ReplayEvent> next();

    const InputCounts& counts() const { return maker_.counts(); }

  private:
    RawlogReader& reader_;
    EventMaker maker_;
    bool finished_ = false;
};

}  // namespace flownav::io
